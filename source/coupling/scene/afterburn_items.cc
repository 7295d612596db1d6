// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/model_bias.h>
#include <contrecoup/coupling/scene/afterburn_items.h>

namespace contrecoup::coupling
{
namespace
{
  /// Energy of detonation [J/kg].
  double detonation_energy(const Explosive &explosive)
  {
    return explosive.jwl.energy_density / explosive.jwl.reference_density;
  }

  /// This energy of afterburn [J/kg] over that of detonation.
  double afterburn_share(const SceneParameters &scene, const double energy)
  {
    return energy / detonation_energy(scene.explosive);
  }

  /// Whose heat of combustion an explosive with values of the user's own has;
  /// empty: its own.
  std::string owner_of_combustion(const SceneParameters &scene)
  {
    return scene.custom_entries.size() > 1
             ? find_explosive(scene.custom_entries.front().second).title +
                 " (Like)"
             : "";
  }

  /// Item about the energy that the products release in air.
  Assumption afterburn(const SceneParameters &scene)
  {
    const std::string owner = owner_of_combustion(scene);
    const std::string usual =
      !scene.has_usual_afterburn ? ""
      : owner.empty()            ? ", by explosive"
      : scene.afterburn > 0.
        ? ", by Like"
        : " by the values of " + owner + "; it is unknown for this explosive";
    const std::string decision =
      scene.afterburn > 0.
        ? brief(1e-6 * scene.afterburn, 3) + " of at most " +
            brief(1e-6 * scene.explosive.afterburn.largest, 2) + " MJ/kg" +
            (owner.empty() ? "" : " by the heat of combustion of " + owner) +
            ", Miller's rate"
        : "left out";
    return {"afterburn",
            decision + usual,
            "energy of afterburn over that of detonation",
            "-",
            afterburn_share(scene, scene.afterburn),
            unknown,
            false,
            "Charge/Afterburn energy"};
  }

  /// Item about what afterburn does to @p quantity at the body: its rise by
  /// the tables of Kingery and Bulmash if all of the energy came with the
  /// detonation, the largest possible; left out: that of the explosive, which
  /// is unknown of one with values of the user's own whose Like has none.
  Assumption afterburn_effect(const SceneParameters &scene,
                              const SceneLayout &layout,
                              const BlastQuantity quantity)
  {
    const IncidentWave without = layout.incident_wave(scene);
    const double energy =
      scene.afterburn > 0. ? scene.afterburn : scene.explosive.afterburn.energy;
    const bool is_known = energy > 0. || owner_of_combustion(scene).empty();
    SceneParameters larger = scene;
    larger.mass *= 1. + afterburn_share(scene, energy);
    const IncidentWave with = layout.incident_wave(larger);
    const double distance = layout.distance;
    const double rise =
      is_known && without.is_tabulated(quantity, distance) &&
          with.is_tabulated(quantity, distance)
        ? with.value(quantity, distance) / without.value(quantity, distance) -
            1.
        : unknown;
    const std::string what =
      quantity == BlastQuantity::impulse ? "impulse" : "peak";
    return {"afterburn_" + what,
            scene.afterburn > 0. ? "in the loads" : "left out",
            "largest rise of the incident " + what + " by afterburn",
            "-",
            rise,
            unknown,
            false,
            "Charge/Afterburn energy"};
  }
} // namespace


std::vector<Assumption> afterburn_items(const SceneParameters &scene,
                                        const SceneLayout &layout)
{
  return {afterburn(scene),
          afterburn_effect(scene, layout, BlastQuantity::overpressure),
          afterburn_effect(scene, layout, BlastQuantity::impulse)};
}


std::string warn_of_energy(const SceneParameters &scene)
{
  if (owner_of_combustion(scene).empty())
    return "";
  const Explosive &like = find_explosive(scene.custom_entries.front().second);
  const double combustion = detonation_energy(like) + like.afterburn.largest;
  const double detonation = detonation_energy(scene.explosive);
  return detonation > combustion
           ? "WARNING: Charge/Custom explosive: the energy of detonation, " +
               brief(1e-6 * detonation, 3) +
               " MJ/kg, exceeds the heat of combustion, " +
               brief(1e-6 * combustion, 3) + " MJ/kg, which is that of " +
               owner_of_combustion(scene) + " and leaves nothing to afterburn"
           : "";
}
} // namespace contrecoup::coupling

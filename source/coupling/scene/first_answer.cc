// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/scene/first_answer.h>
#include <contrecoup/materials/explosives.h>
#include <contrecoup/numerics/injury/blast_injury.h>
#include <contrecoup/numerics/injury/kingery_bulmash.h>

namespace contrecoup::coupling
{
namespace
{
  constexpr double sea_level = 101325.; // [Pa]

  std::string
  kilopascal(const KingeryBulmash &tables, BlastQuantity quantity, double at)
  {
    const double value = 1e-3 * tables.value(quantity, at);
    return brief(value, value < 1000. ? 3 : 4) + " kPa";
  }


  std::string percent(const double part)
  {
    return part > 0.99    ? "more than 99 %"
           : part < 0.001 ? "less than 0.1 %"
                          : brief(100. * part, 2) + " %";
  }


  /// The TNT equivalence in words; none for TNT itself.
  std::string equivalence(const SceneParameters &scene)
  {
    const TntEquivalence &tnt = find_explosive(scene.explosive).tnt;
    return tnt.pressure == 1. && tnt.impulse == 1.
             ? ""
             : " (as " + brief(tnt.pressure, 3) +
                 " times its mass of TNT for pressures, " +
                 brief(tnt.impulse, 3) + " for impulses: " + tnt.source + ")";
  }


  /// Line about a peak overpressure [Pa] that bursts eardrums, and the load
  /// [Pa] of the lung that comes with it for @p duration [s].
  std::string injury_line(const std::string &peak,
                          const double overpressure,
                          const std::string &place,
                          const double load,
                          const double duration,
                          const double body_mass)
  {
    const double exposure =
      load / lung_median_lethal_overpressure(duration, body_mass, sea_level);
    return "  under the " + peak + " peak: eardrum rupture " +
           percent(eardrum_rupture_probability(overpressure)) + "; " + place +
           " loads the lung with " + brief(exposure, 2) +
           " of what kills half, death by lung injury: " +
           percent(lung_lethality_probability(exposure));
  }
} // namespace


std::vector<std::string> first_answer(const SceneParameters &scene,
                                      const SceneLayout &layout,
                                      const double body_mass)
{
  const TntEquivalence &tnt = find_explosive(scene.explosive).tnt;
  const KingeryBulmash pressures("spherical", scene.mass * tnt.pressure);
  const KingeryBulmash impulses("spherical", scene.mass * tnt.impulse);
  const double distance = layout.distance;
  for (const auto &[tables, quantity] :
       {std::pair{&pressures, BlastQuantity::overpressure},
        {&pressures, BlastQuantity::reflected_overpressure},
        {&pressures, BlastQuantity::arrival},
        {&impulses, BlastQuantity::impulse},
        {&impulses, BlastQuantity::duration}})
    if (!tables->covers(quantity, distance))
      return {
        "no first answer: the tables of Kingery and Bulmash do not cover " +
        brief(scene.mass) + " kg of " + scene.explosive + " at " +
        brief(distance) + " m"};
  const double duration = impulses.value(BlastQuantity::duration, distance);
  const double incident =
    pressures.value(BlastQuantity::overpressure, distance);
  const double reflected =
    pressures.value(BlastQuantity::reflected_overpressure, distance);
  return {
    "first answer, by tables and without a run: " + brief(scene.mass) +
      " kg of " + scene.explosive + equivalence(scene) + " at " +
      brief(distance) + " m",
    "  incident wave in free air: peak " +
      kilopascal(pressures, BlastQuantity::overpressure, distance) +
      ", impulse " +
      brief(impulses.value(BlastQuantity::impulse, distance), 3) +
      " Pa s, arrival " +
      brief(1e3 * pressures.value(BlastQuantity::arrival, distance), 3) +
      " ms, positive phase " + brief(1e3 * duration, 3) + " ms",
    "  reflected by a wall there: peak " +
      kilopascal(pressures, BlastQuantity::reflected_overpressure, distance),
    injury_line("incident",
                incident,
                "standing in the open",
                standing_load(incident, sea_level),
                duration,
                body_mass),
    injury_line("reflected",
                reflected,
                "standing before a wall",
                reflected,
                duration,
                body_mass),
    ("  left out: reflection by the ground, afterburn, shape and tissues of the "
     "body; a run has them")};
}
} // namespace contrecoup::coupling

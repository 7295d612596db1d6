// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/model_bias.h>
#include <contrecoup/coupling/scene/first_answer.h>
#include <contrecoup/numerics/injury/blast_injury.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::coupling
{
namespace
{
  std::string kilopascal(const double pressure)
  {
    const double value = 1e-3 * pressure;
    return brief(value, value < 1000. ? 3 : 4) + " kPa";
  }


  TableAnswer::Effect effect_on_person(const double overpressure,
                                       const double load,
                                       const double duration,
                                       const double body_mass)
  {
    const double exposure = load / lung_median_lethal_overpressure(
                                     duration, body_mass, sea_level_pressure);
    return {overpressure,
            eardrum_rupture_probability(overpressure),
            exposure,
            lung_lethality_probability(exposure)};
  }


  std::string effect_line(const std::string &peak,
                          const std::string &place,
                          const std::string &mass,
                          const TableAnswer::Effect &effect)
  {
    return "  under the " + peak + " peak: eardrum rupture " +
           percent(effect.eardrum_rupture) + "; a person of " + mass +
           " kg who stands " + place + " has the lung loaded with " +
           brief(effect.lung_exposure, 2) +
           " of what kills half, death by lung injury: " +
           percent(effect.lung_lethality);
  }


  /// The end of the tables that is nearest to a distance, to four digits that
  /// they cover.
  std::string end_of_tables(const IncidentWave &wave, const double distance)
  {
    constexpr double round_off = 0.01;
    const double end = wave.nearest_tabulated(distance);
    const double digit = std::pow(10., std::floor(std::log10(end)) - 3.);
    return end > distance
             ? "no less than " +
                 brief(std::ceil(end / digit - round_off) * digit)
             : "no more than " +
                 brief(std::floor(end / digit + round_off) * digit);
  }


  /// Possible addition by a plane: at most, at places at which both waves are
  /// one, that to a surface burst.
  std::string reflection_in_words(const SceneParameters &scene,
                                  const SceneLayout &layout,
                                  const ReflectingPlane &plane)
  {
    const std::string what =
      "reflection by the " + plane.name +
      (plane.entry.empty() ? "" : " (" + plane.entry + ")");
    const dealii::Point<3> &skin = layout.nearest_skin;
    if ((plane.image(layout.charge) - skin) * (layout.charge - skin) <= 0.)
      return what + ", which the body keeps from the nearest skin";
    if (plane.distance(layout.charge) > layout.distance)
      return what + ", which comes after the wave";
    const auto rise = [&](const BlastQuantity quantity) {
      const double part = merged_rise(scene, layout, quantity);
      return std::isfinite(part) ? brief(100. * part, 2) + " %"
                                 : "an unknown part";
    };
    return what + ", which adds some " + rise(BlastQuantity::overpressure) +
           " to the peak and " + rise(BlastQuantity::impulse) +
           " to the impulse where it has merged with the wave";
  }

  /// Effects that tables alone leave out and a run has.
  std::string left_out_in_words(const SceneParameters &scene,
                                const SceneLayout &layout,
                                const std::vector<ChosenSide> &sides)
  {
    std::vector<std::string> parts;
    for (const ReflectingPlane &plane : reflecting_planes(layout, sides))
      if (sees_reflection(scene, layout, plane))
        parts.push_back(reflection_in_words(scene, layout, plane));
    parts.emplace_back(scene.wants_injury()
                         ? "shape and tissues of the body; a run has them"
                       : parts.empty() ? "shape of the body; a run has it"
                                       : "shape of the body; a run has them");
    return "  left out: " + join(parts, ", ");
  }
} // namespace


std::optional<TableAnswer> table_answer(const SceneParameters &scene,
                                        const SceneLayout &layout,
                                        const double body_mass)
{
  const IncidentWave wave = layout.incident_wave(scene);
  const double distance = layout.distance;
  if (!wave.is_tabulated(distance))
    return {};
  const auto value = [&](const BlastQuantity quantity) {
    return wave.value(quantity, distance);
  };
  const double duration = value(BlastQuantity::duration);
  const double incident = value(BlastQuantity::overpressure);
  const double reflected = value(BlastQuantity::reflected_overpressure);
  return TableAnswer{
    value(BlastQuantity::arrival),
    value(BlastQuantity::impulse),
    duration,
    effect_on_person(incident,
                     standing_load(incident, sea_level_pressure),
                     duration,
                     body_mass),
    effect_on_person(reflected, reflected, duration, body_mass),
    effect_on_person(incident, incident, duration, body_mass)};
}


std::string equivalence_in_words(const Explosive &explosive)
{
  const TntEquivalence &tnt = explosive.tnt;
  if (tnt.is_published && tnt.pressure == 1. && tnt.impulse == 1.)
    return "";
  return "as " + in_words(tnt) + ": " + tnt.source +
         (tnt.is_published ? "" : ", an estimate, not measured");
}


std::string percent(const double probability)
{
  return probability > 0.99    ? "more than 99 %"
         : probability < 0.001 ? "less than 0.1 %"
                               : brief(100. * probability, 2) + " %";
}


std::string burst_in_words(const SceneLayout &layout)
{
  return layout.is_surface_burst
           ? "of a surface burst (hemispherical tables, about those of " +
               brief(IncidentWave::surface_mass) + " times the mass)"
           : "in free air";
}


std::string unknown_beforehand()
{
  return "the front reaches the body before it has swept the charge's mass of "
         "air; what it has there is not known beforehand";
}


std::string distance_along_x(const SceneParameters &scene,
                             const SceneLayout &layout)
{
  const std::string along = brief(layout.distance_along_x);
  return scene.place || !std::isfinite(layout.distance_along_x) ||
             along == brief(layout.distance)
           ? ""
           : " (" + along + " m to the skin along x)";
}


std::vector<std::string> first_answer(const SceneParameters &scene,
                                      const SceneLayout &layout,
                                      const double body_mass,
                                      const std::string &person,
                                      const std::vector<ChosenSide> &sides)
{
  const std::string what =
    brief(scene.mass) + " kg of " + scene.explosive.title;
  const std::string where =
    " at " + brief(layout.distance) + " m" + distance_along_x(scene, layout);
  const auto answer = table_answer(scene, layout, body_mass);
  const std::string left_out = left_out_in_words(scene, layout, sides);
  if (!answer)
  {
    const IncidentWave wave = layout.incident_wave(scene);
    return {"no first answer: the tables of Kingery and Bulmash do not cover " +
              what + where + ", but " + end_of_tables(wave, layout.distance) +
              " m",
            std::string("  incident wave of ") +
              (wave.is_tabulated(BlastQuantity::overpressure, layout.distance)
                 ? "the tables"
                 : "the tables, continued by a point source") +
              ": peak " + kilopascal(layout.overpressure) + ", arrival " +
              brief(1e3 * layout.arrival, 3) + " ms",
            left_out};
  }
  const std::string equivalence = equivalence_in_words(scene.explosive);
  const ModelBias bias =
    model_bias(scene.burst(layout.is_surface_burst), layout.distance);
  std::vector<std::string> lines = {
    "first answer, by tables and without a run: " + what +
      (equivalence.empty() ? "" : " (" + equivalence + ")") + where +
      (person.empty() ? "" : " from " + person),
    "  incident wave " + burst_in_words(layout) + ": peak " +
      kilopascal(answer->in_the_open.overpressure) + ", impulse " +
      brief(answer->impulse, 3) + " Pa s, arrival " +
      brief(1e3 * answer->arrival, 3) + " ms, positive phase " +
      brief(1e3 * answer->duration, 3) + " ms",
    "  reflected by a wall there: peak " +
      kilopascal(answer->before_a_wall.overpressure),
    effect_line(
      "incident", "in the open", brief(body_mass, 3), answer->in_the_open),
    effect_line(
      "reflected", "before a wall", brief(body_mass, 3), answer->before_a_wall),
    left_out};
  if (!layout.is_far(scene))
    lines.push_back("  " + unknown_beforehand());
  lines.push_back(
    "  bias of a run's incident wave, whatever its cells: " + in_words(bias) +
    (bias.gap.empty() ? " of these figures" : ""));
  return lines;
}
} // namespace contrecoup::coupling

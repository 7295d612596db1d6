// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/record/gauge_tables.h>
#include <contrecoup/gas/record/record_gaps.h>
#include <contrecoup/numerics/injury/blast_injury.h>
#include <contrecoup/numerics/injury/chest_wall.h>
#include <contrecoup/numerics/injury/injury_criteria.h>
#include <contrecoup/numerics/injury/load_injury.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <regex>

namespace contrecoup::gas
{
namespace
{
  const std::string chest = "chest", back = "back";
  const std::vector<std::string> arms{"left upper arm", "right upper arm"};
  const std::string device = "device ";
  /// Least first_phase_fraction for which the lung exposure of a wave is taken
  /// for that of a simple one.
  constexpr double simple = 0.75;
  const std::string header =
    "measure,place,value,unit,definition,cut off [-]\n";

  /// @param is_cut whether the value is a lower limit
  std::string row(const std::string &measure,
                  const std::string &place,
                  const double value,
                  const std::string &unit,
                  const std::string &definition,
                  const bool is_cut = false)
  {
    return join({measure,
                 place,
                 exact(value),
                 unit,
                 "\"" + definition +
                   (is_cut ? "; a lower limit: the run ends too early" : "") +
                   "\"",
                 is_cut ? "1" : "0"},
                ",") +
           "\n";
  }


  /// Whether a time is that of the end of the run.
  bool is_end(const double time, const double end)
  {
    return time >= end * (1. - 1e-9);
  }


  /// Whether the last word of a gauge's name is "ear", as that of "rear" is
  /// not.
  bool is_ear(const std::string &place)
  {
    return std::regex_match(place, std::regex("(.*[^[:alnum:]])?ear"));
  }


  struct Velocity
  {
    double value;
    bool is_cut; ///< whether it is a lower limit
  };


  /// Velocities of the chest wall at places; each that has none is left out.
  std::vector<Velocity>
  chest_wall_velocities(const std::map<std::string, LoadInjury> &injuries,
                        const std::vector<std::string> &places)
  {
    std::vector<Velocity> velocities;
    for (const std::string &place : places)
      if (const auto found = injuries.find(place); found != injuries.end())
        velocities.push_back(
          {found->second.chest_wall_velocity, found->second.is_velocity_cut});
    return velocities;
  }


  Velocity mean_of(const std::vector<Velocity> &velocities)
  {
    Velocity mean{0., false};
    for (const Velocity &velocity : velocities)
      mean = {mean.value + velocity.value / velocities.size(),
              mean.is_cut || velocity.is_cut};
    return mean;
  }


  /// Mean over front, back and both sides; before a plane of symmetry, one
  /// side stands for both. Not known without front, back and a side.
  std::optional<Velocity>
  mean_over_sides(const std::map<std::string, LoadInjury> &injuries,
                  const std::vector<std::string> &front_and_back,
                  const std::vector<std::string> &sides)
  {
    const auto first = chest_wall_velocities(injuries, front_and_back),
               second = chest_wall_velocities(injuries, sides);
    if (first.size() < 2 || second.empty())
      return std::nullopt;
    return mean_of({mean_of(first), mean_of(second)});
  }


  std::string chest_wall_rows(const std::map<std::string, LoadInjury> &injuries)
  {
    std::string text;
    const std::vector<std::string> all{chest, back, arms[0], arms[1]};
    for (const std::string &place : all)
      for (const Velocity &velocity : chest_wall_velocities(injuries, {place}))
        text += row("chest_wall_velocity",
                    place,
                    velocity.value,
                    "m/s",
                    "largest inward velocity of a mass on a spring before one "
                    "lung under the overpressure at this place (Axelsson and "
                    "Yelverton 1996)",
                    velocity.is_cut);
    const auto two = chest_wall_velocities(injuries, {chest, back});
    const auto four = mean_over_sides(injuries, {chest, back}, arms);
    if (two.size() < 2)
      return text;
    const Velocity mean = four.value_or(mean_of(two));
    return text +
           row("chest_wall_velocity",
               "trunk",
               mean.value,
               "m/s",
               "mean of the velocities at chest" +
                 std::string(four ? ", back and both upper arms" : " and back"),
               mean.is_cut);
  }


  /// Rows of a blast test device.
  std::string device_rows(const std::map<std::string, LoadInjury> &injuries)
  {
    const auto velocity = mean_over_sides(injuries,
                                          {device + "front", device + "back"},
                                          {device + "left", device + "right"});
    if (!velocity)
      return "";
    return row("chest_wall_velocity",
               "device",
               velocity->value,
               "m/s",
               "mean over the four gauges of a blast test device (Axelsson "
               "and Yelverton 1996)",
               velocity->is_cut) +
           row("thorax_injury_index",
               "device",
               thorax_injury_index(velocity->value),
               "-",
               "adjusted severity of injury index of that mean (Axelsson and "
               "Yelverton 1996): " +
                 injury_criterion("chest_wall_mean").meaning(velocity->value),
               velocity->is_cut);
  }


  /// "a body mass of 78.5 kg (Bowen et al. 1968)".
  std::string of_mass(const double body_mass)
  {
    return "a body mass of " + brief(body_mass) + " kg (Bowen et al. 1968)";
  }


  std::string
  lung_exposure_rows(const std::map<std::string, LoadInjury> &injuries,
                     const double body_mass)
  {
    std::string text;
    for (const std::string &place : {chest, back, arms[0], arms[1]})
    {
      const auto found = injuries.find(place);
      if (found != injuries.end() && found->second.pulse.duration > 0.)
        text += row(
          "lung_exposure",
          place,
          found->second.lung_exposure,
          "-",
          "peak overpressure on the skin over the free-field load that half "
          "survive for this positive phase and " +
            of_mass(body_mass),
          found->second.pulse.is_cut);
    }
    return text;
  }


  /// Definitions of air_injury_quantities.
  std::array<std::string, 5> air_injury_definitions(const double body_mass)
  {
    return {
      {"side-on plus dynamic pressure over the load that half survive for this "
       "positive phase, among products a longer one, and " +
         of_mass(body_mass),
       "probability of death within 24 h by lung injury of a person who stands in "
       "the open (Bowen et al. 1968)",
       "probability by the peak overpressure (on a wall the reflected one; TNO CPR 16E, 1992)",
       "largest inward velocity of a mass on a spring before one lung under the "
       "side-on overpressure alone (equation of Axelsson and Yelverton 1996); not "
       "the mean over the four gauges of a blast test device, so that its levels "
       "of injury do not hold",
       "impulse of the first wave within the first positive phase, until a later "
       "wave rises by a tenth of the first peak, over the impulse of all positive "
       "phases, among products over that of the first; 1 in a simple wave, for "
       "which alone the lung exposure is defined"}};
  }


  std::string
  air_rows(const AirBlast &air, const double body_mass, const bool with_chest)
  {
    std::string rows;
    auto values = air_injury_values(air, body_mass);
    auto definitions = air_injury_definitions(body_mass);
    if (values[4] <= simple)
    {
      const std::string reason =
        ", as the wave is not simple: see first_phase_fraction";
      const double bound = mapped_injury_values(air, body_mass)[1];
      const bool is_bounded = bound > values[1];
      values[1] = is_bounded ? bound : values[1];
      definitions[0] += "; not known by it" + reason;
      definitions[1] +=
        (is_bounded ? "; that of an endless phase" : "; not known by it") +
        reason;
    }
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      const auto &[name, unit] = air_injury_quantities[k];
      if (!std::isnan(values[k]) &&
          (with_chest || name != "chest_wall_velocity"))
        rows += row(name,
                    air.place,
                    values[k],
                    unit,
                    definitions[k],
                    name == "chest_wall_velocity" &&
                      air.exposure.chest.is_fastest_now());
    }
    const double load_duration =
      air.exposure.durations(air.blast.duration).second;
    if (!std::isnan(values[0]) && load_duration > air.blast.duration)
      rows += row("lung_load_duration",
                  air.place,
                  load_duration,
                  "s",
                  "duration of the load for the lung exposure, to the end of a "
                  "later phase among products");
    if (with_chest)
      rows +=
        row("peak_overpressure",
            air.place,
            air.blast.peak,
            "Pa",
            "peak (on a wall the reflected one); limit exceeded: " +
              injury_criterion("peak_overpressure").meaning(air.blast.peak));
    return rows;
  }


  /// Whether the verdicts on lungs agree, under the least and the largest load.
  bool say_the_same(const AirInjury &least, const AirInjury &largest)
  {
    const double threshold =
      injury_criterion("lung_exposure_air").thresholds.front().first;
    return largest.lung_lethality - least.lung_lethality < 0.1 &&
           (least.lung_exposure > threshold) ==
             (largest.lung_exposure > threshold);
  }
} // namespace


const std::vector<std::pair<std::string, std::string>> air_injury_quantities = {
  {"lung_exposure", "-"},
  {"lung_lethality", "-"},
  {"eardrum_rupture", "-"},
  {"chest_wall_velocity", "m/s"},
  {"first_phase_fraction", "-"}};


std::array<double, 5> air_injury_values(const AirBlast &air,
                                        const double body_mass)
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (!(air.blast.peak > 0.) || std::isnan(air.exposure.load))
    return {{unknown, unknown, unknown, unknown, unknown}};
  // Products overexpand: later phases of a simple wave have impulse, too.
  const double first_phase =
    air.is_cut
      ? unknown
      : air.exposure.waves.first_fraction(air.blast.impulse,
                                          air.exposure.is_among_products()
                                            ? air.blast.impulse
                                            : air.total_impulse);
  const auto [shortest, longest] = air.exposure.durations(air.blast.duration);
  const auto injury_of = [&](const double duration) {
    return air_injury(
      {air.blast.peak, duration}, air.exposure.load, air.ambient, body_mass);
  };
  const AirInjury least = injury_of(shortest), injury = injury_of(longest);
  const bool is_known =
    !air.is_cut && !air.exposure.goes_on() && say_the_same(least, injury);
  return {{is_known ? injury.lung_exposure : unknown,
           is_known ? injury.lung_lethality : unknown,
           injury.eardrum_rupture,
           air.exposure.chest.largest_velocity,
           first_phase}};
}


std::array<double, 5> mapped_injury_values(const AirBlast &air,
                                           const double body_mass)
{
  constexpr double certain = 0.99, harmless = 1e-3, endless = 1e3;
  auto values = air_injury_values(air, body_mass);
  double &lethality = values[1];
  const bool is_simple = std::isfinite(lethality) && values[4] > simple;
  if (is_simple || lethality > certain || std::isnan(values[2]))
    return values;
  const double bound =
    air_injury(
      {air.blast.peak, endless}, air.exposure.load, air.ambient, body_mass)
      .lung_lethality;
  lethality =
    bound < harmless ? bound : std::numeric_limits<double>::quiet_NaN();
  return values;
}


bool lungs_are_unknown(const AirBlast &air, const double body_mass)
{
  const auto injuries = air_injury_values(air, body_mass);
  return !air.is_cut && std::isnan(injuries[0]) && !std::isnan(injuries[2]);
}


std::string words_of_unknown_lungs(const std::string &places)
{
  return "injuries of lungs are unknown at " + places +
         " beside the products of the explosive, where they depend on which "
         "phases of the load count";
}


std::vector<NamedValue> gauge_values(const BlastMeasures &blast,
                                     const double peak_time)
{
  const auto [peak, impulse, arrival, duration] = recorded_map_values(blast);
  return {{"arrival", "s", arrival},
          {"peak", "Pa", peak},
          {"peak time", "s", std::isnan(peak) ? peak : peak_time},
          {"impulse", "Pa s", impulse},
          {"positive phase", "s", duration}};
}


std::string gauge_measures_table(const std::vector<GaugeBlast> &gauges,
                                 const double time)
{
  std::vector<std::string> words = {"place"};
  for (const NamedValue &value : gauge_values({}, 0.))
    words.push_back(value.name + " [" + value.unit + "]");
  std::string text = join(words, ",") + ",cut off [-]\n";
  for (const GaugeBlast &gauge : gauges)
  {
    words = {gauge.place};
    for (const NamedValue &value : gauge_values(gauge.blast, gauge.peak_time))
      words.push_back(std::isnan(value.value) ? "nan" : exact(value.value));
    text +=
      join(words, ",") + (is_cut_off(gauge.blast, time) ? ",1\n" : ",0\n");
  }
  return text;
}


std::string gauge_injury_table(const std::vector<GaugeBlast> &gauges,
                               const std::vector<double> &times,
                               const double body_mass)
{
  std::map<std::string, LoadInjury> injuries;
  std::string ears;
  const double end = times.back();
  for (const GaugeBlast &gauge : gauges)
  {
    if (gauge.place != chest && gauge.place != back &&
        std::count(arms.begin(), arms.end(), gauge.place) == 0 &&
        !is_ear(gauge.place) && gauge.place.rfind(device, 0) != 0)
      continue;
    const LoadInjury injury = load_injury(
      times,
      gauge.overpressures,
      {gauge.blast.peak, gauge.blast.duration, is_cut_off(gauge.blast, end)},
      body_mass);
    injuries[gauge.place] = injury;
    if (is_ear(gauge.place))
      ears += row("eardrum_rupture",
                  gauge.place,
                  injury.eardrum_rupture,
                  "-",
                  "probability by the peak overpressure at this ear (TNO CPR "
                  "16E, 1992)",
                  !(gauge.blast.peak > 0.) || is_end(gauge.peak_time, end));
  }
  const std::string rows = chest_wall_rows(injuries) + device_rows(injuries) +
                           lung_exposure_rows(injuries, body_mass) + ears;
  return rows.empty() ? "" : header + rows;
}


std::string air_injury_table(const std::vector<AirBlast> &places,
                             const double body_mass,
                             const bool with_chest)
{
  std::string rows;
  for (const AirBlast &air : places)
    if (air.blast.peak > 0. && air.blast.duration > 0. &&
        is_habitable(air.ambient))
      rows += air_rows(air, body_mass, with_chest);
  return rows.empty() ? "" : header + rows;
}
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/injury/channel_filter.h>
#include <contrecoup/numerics/injury/head_injury.h>
#include <contrecoup/solid/body/tissue_measures.h>
#include <contrecoup/solid/injury/brain_measures.h>

#include <cmath>
#include <utility>

namespace contrecoup::solid
{
namespace
{
  namespace mpi = dealii::Utilities::MPI;

  /// Share of the brain that decides on injury_strain_95.
  constexpr double tail = 0.05;

  /// Turning of a head that is round-off of its translation: the skull, a tenth
  /// of a metre from the centre, moves by 1e-5 of the head's speed [1/m].
  constexpr double least_turn = 1e-4;

  std::array<double, 3> largest_components(const VectorHistory &history)
  {
    std::array<double, 3> largest{};
    for (const std::array<double, 3> &value : history.values)
      for (unsigned int d = 0; d < 3; ++d)
        largest[d] = std::max(largest[d], std::abs(value[d]));
    return largest;
  }

  /// @param sums volumes: of all, with more than 15 % and 25 % strain, and
  /// cavitated; then the members of BrainSums; then the volumes whose strain
  /// grows and that are tense
  /// @param tension_grows whether the least pressure is a lower limit
  void add_parts(const std::vector<double> &sums,
                 const double strain,
                 const bool tension_grows,
                 std::vector<InjuryMeasure> &list)
  {
    const double volume = sums[0];
    const bool is_tense = tension_grows || sums[8] > 0.;
    list.push_back(
      known_measure("injury_cavitating_fraction", sums[3] / volume));
    // All of the brain cannot become more.
    list.back().is_cut = is_tense && sums[3] < volume;
    list.push_back(known_measure("injury_cavitation_dose", sums[4] / volume));
    list.back().is_cut = is_tense;
    if (sums[6] > 0.)
      list.push_back(known_measure("injury_pressure_roughness",
                                   std::sqrt(sums[5] / sums[6])));
    for (const auto &[name, value] : {std::pair{"injury_strain_95", strain},
                                      {"injury_csdm_15", sums[1] / volume},
                                      {"injury_csdm_25", sums[2] / volume}})
    {
      list.push_back(known_measure(name, value));
      list.back().is_cut = sums[7] > tail * volume;
    }
  }
} // namespace


void record_pressures(const double span,
                      const std::vector<double> &pressures,
                      const std::vector<double> &averages,
                      const bool averaged,
                      std::vector<BrainSample> &samples,
                      BrainSums &sums)
{
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    BrainSample &sample = samples[i];
    const double weight = span * sample.volume;
    const double pressure = averaged ? averages[i] : pressures[i];
    sample.record_pressure(pressure);
    sums.cavitation_dose += pressure < cavitation_pressure ? weight : 0.;
    const double fluctuation = pressures[i] - averages[i];
    sums.fluctuation_square += weight * fluctuation * fluctuation;
    sums.average_square += weight * averages[i] * averages[i];
  }
}


std::vector<InjuryMeasure>
brain_measures(const std::vector<BrainSample> &samples,
               const BrainSums &of_rank,
               const MPI_Comm communicator,
               const bool tension_grows)
{
  std::vector<double> strains, volumes;
  // Highest pressure and tension, and those that are the last ones.
  std::vector<double> extremes(4, 0.);
  std::vector<double> sums{0.,
                           0.,
                           0.,
                           0.,
                           of_rank.cavitation_dose,
                           of_rank.fluctuation_square,
                           of_rank.average_square,
                           0.,
                           0.};
  for (const BrainSample &sample : samples)
  {
    strains.push_back(sample.peak_strain);
    volumes.push_back(sample.volume);
    sums[0] += sample.volume;
    sums[1] += sample.peak_strain > 0.15 ? sample.volume : 0.;
    sums[2] += sample.peak_strain > 0.25 ? sample.volume : 0.;
    sums[3] +=
      sample.lowest_pressure < cavitation_pressure ? sample.volume : 0.;
    sums[7] += sample.strain_grows ? sample.volume : 0.;
    sums[8] += sample.is_tense ? sample.volume : 0.;
    const std::array<double, 4> found{
      {sample.peak_pressure,
       -sample.lowest_pressure,
       sample.pressure_rises ? sample.peak_pressure : 0.,
       sample.pressure_falls ? -sample.lowest_pressure : 0.}};
    for (unsigned int k = 0; k < found.size(); ++k)
      extremes[k] = std::max(extremes[k], found[k]);
  }
  mpi::sum(sums, communicator, sums);
  mpi::max(extremes, communicator, extremes);
  std::vector<InjuryMeasure> list;
  if (!(sums[0] > 0.))
    return list;
  const auto is_last = [&](const unsigned int k) {
    return extremes[k] > 0. && extremes[k] == extremes[k + 2];
  };
  list.push_back(
    known_measure("injury_intracranial_pressure_peak", extremes[0]));
  list.back().is_cut = is_last(0);
  list.push_back(
    known_measure("injury_intracranial_pressure_lowest", 0. - extremes[1]));
  list.back().is_cut = tension_grows || is_last(1);
  add_parts(sums,
            percentile(strains, volumes, 1. - tail, communicator),
            list.back().is_cut,
            list);
  return list;
}


void HeadMotion::add(const double time,
                     const dealii::Tensor<1, 3> &velocity,
                     const dealii::Tensor<1, 3> &angular_velocity)
{
  times.push_back(time);
  velocities.push_back({{velocity[0], velocity[1], velocity[2]}});
  angular_velocities.push_back(
    {{angular_velocity[0], angular_velocity[1], angular_velocity[2]}});
}


std::vector<InjuryMeasure> head_motion_measures(const HeadMotion &motion,
                                                const std::string &moving)
{
  if (motion.times.size() < 2)
    return {};
  const VectorHistory velocities = channel_class_filter(
                        {motion.times, motion.velocities}, head_channel_class),
                      turning = channel_class_filter(
                        {motion.times, motion.angular_velocities},
                        head_channel_class);
  const std::array<double, 3> largest = largest_components(turning);
  const std::array<double, 3> speeds = largest_components(velocities);
  const double round_off =
    least_turn * *std::max_element(speeds.begin(), speeds.end());
  bool turns_faster = false;
  for (unsigned int d = 0; d < 3; ++d)
    turns_faster =
      turns_faster || (largest[d] > round_off &&
                       std::abs(turning.values.back()[d]) == largest[d]);
  const HeadInjuryCriterion criterion =
    head_injury_criterion(velocities.times, velocities.values, 0.015);

  std::vector<InjuryMeasure> list;
  const auto add = [&](InjuryMeasure measure, const bool is_cut) {
    measure.limits =
      "of " + moving + ", filtered by CFC 1000; " + measure.limits;
    measure.is_cut = is_cut;
    list.push_back(measure);
    for (InjuryMeasure probability : probabilities_of(measure))
    {
      probability.is_cut = is_cut;
      list.push_back(probability);
    }
  };
  add(known_measure("injury_hic15", criterion.value),
      criterion.value > 0. && criterion.end == velocities.times.back());
  add(known_measure("injury_bric", brain_injury_criterion(largest)),
      turns_faster);
  return list;
}


void mark_lower_limits(const double end, std::vector<InjuryMeasure> &list)
{
  // Ends of time steps are sums with round-off.
  constexpr double long_enough = 0.01 * (1. - 1e-9); // [s]
  const auto grows = [](const std::string &name) {
    for (const char *measure :
         {"injury_strain_95", "injury_csdm_", "injury_hic15", "injury_bric"})
      if (name.rfind(measure, 0) == 0)
        return true;
    return false;
  };
  for (InjuryMeasure &measure : list)
    measure.is_cut =
      measure.is_cut || (end < long_enough && grows(measure.value.name));
}


std::string to_csv(const std::vector<InjuryMeasure> &measures)
{
  std::string text = "measure,value,unit,threshold,limits,cut off [-]\n";
  for (const InjuryMeasure &measure : measures)
    text += measure.value.name + "," + exact(measure.value.value) + "," +
            measure.value.unit + ",\"" + measure.threshold + "\",\"" +
            measure.limits + "\"," + (measure.is_cut ? "1" : "0") + "\n";
  return text;
}
} // namespace contrecoup::solid

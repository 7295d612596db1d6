// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/injury/head_injury.h>
#include <contrecoup/solid/body/tissue_measures.h>
#include <contrecoup/solid/injury/brain_measures.h>

#include <cmath>

namespace contrecoup::solid
{
namespace
{
  namespace mpi = dealii::Utilities::MPI;

  /// @param sums volumes: of all, with more than 15 % and 25 % strain, and
  /// cavitated; then the members of BrainSums
  void add_parts(const std::vector<double> &sums,
                 const double strain,
                 std::vector<InjuryMeasure> &list)
  {
    const double volume = sums[0];
    list.push_back(
      known_measure("injury_cavitating_fraction", "-", sums[3] / volume));
    list.push_back(
      known_measure("injury_cavitation_dose", "s", sums[4] / volume));
    if (sums[6] > 0.)
      list.push_back(known_measure(
        "injury_pressure_roughness", "-", std::sqrt(sums[5] / sums[6])));
    list.push_back(known_measure("injury_strain_95", "-", strain));
    list.push_back(known_measure("injury_csdm_15", "-", sums[1] / volume));
    list.push_back(known_measure("injury_csdm_25", "-", sums[2] / volume));
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
               const MPI_Comm communicator)
{
  std::vector<double> strains, volumes;
  double peak = 0., lowest = 0.;
  std::vector<double> sums{0.,
                           0.,
                           0.,
                           0.,
                           of_rank.cavitation_dose,
                           of_rank.fluctuation_square,
                           of_rank.average_square};
  for (const BrainSample &sample : samples)
  {
    strains.push_back(sample.peak_strain);
    volumes.push_back(sample.volume);
    sums[0] += sample.volume;
    sums[1] += sample.peak_strain > 0.15 ? sample.volume : 0.;
    sums[2] += sample.peak_strain > 0.25 ? sample.volume : 0.;
    sums[3] +=
      sample.lowest_pressure < cavitation_pressure ? sample.volume : 0.;
    peak = std::max(peak, sample.peak_pressure);
    lowest = std::min(lowest, sample.lowest_pressure);
  }
  mpi::sum(sums, communicator, sums);
  std::vector<InjuryMeasure> list;
  if (!(sums[0] > 0.))
    return list;
  list.push_back(known_measure(
    "injury_intracranial_pressure_peak", "Pa", mpi::max(peak, communicator)));
  list.push_back(known_measure("injury_intracranial_pressure_lowest",
                               "Pa",
                               mpi::min(lowest, communicator)));
  add_parts(sums, percentile(strains, volumes, 0.95, communicator), list);
  return list;
}


InjuryMeasure
head_motion_measure(const std::vector<double> &times,
                    const std::vector<std::array<double, 3>> &velocities,
                    const std::string &motion)
{
  InjuryMeasure measure = known_measure(
    "injury_hic15", "-", head_injury_criterion(times, velocities, 0.015).value);
  measure.limits = "of " + motion + "; " + measure.limits;
  return measure;
}


void update_largest_angular_velocity(
  std::array<double, 3> &largest,
  const dealii::Tensor<1, 3> &angular_velocity)
{
  for (unsigned int d = 0; d < 3; ++d)
    largest[d] = std::max(largest[d], std::abs(angular_velocity[d]));
}


InjuryMeasure head_rotation_measure(const std::array<double, 3> &largest,
                                    const std::string &motion)
{
  InjuryMeasure measure =
    known_measure("injury_bric", "-", brain_injury_criterion(largest));
  measure.limits = "of " + motion + "; " + measure.limits;
  return measure;
}


std::string to_csv(const std::vector<InjuryMeasure> &measures)
{
  std::string text = "measure,value,unit,threshold,limits\n";
  for (const InjuryMeasure &measure : measures)
    text += measure.value.name + "," + exact(measure.value.value) + "," +
            measure.value.unit + ",\"" + measure.threshold + "\",\"" +
            measure.limits + "\"\n";
  return text;
}
} // namespace contrecoup::solid

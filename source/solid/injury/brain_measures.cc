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

  void add_pressures(const double peak,
                     const double lowest,
                     std::vector<InjuryMeasure> &list)
  {
    list.push_back(
      {{"injury_intracranial_pressure_peak", "Pa", peak},
       "173 kPa minor, 235 kPa serious (Ward et al. 1980, recalled)",
       "of impacts; blasts that are survived exceed it"});
    list.push_back({{"injury_intracranial_pressure_lowest", "Pa", lowest},
                    "-100 kPa: cavitation",
                    "elements do not cavitate: tension goes on"});
  }

  /// @param sums volumes: of all, with more than 15 % and 25 % strain, and
  /// cavitated; then the members of BrainSums
  void add_parts(const std::vector<double> &sums,
                 const double strain,
                 std::vector<InjuryMeasure> &list)
  {
    const double volume = sums[0];
    const std::string model =
      "thresholds were found with other models of the head";
    list.push_back({{"injury_cavitating_fraction", "-", sums[3] / volume},
                    "0.072 (DDM, recalled)",
                    "part of the brain that was ever below -100 kPa"});
    list.push_back({{"injury_cavitation_dose", "s", sums[4] / volume},
                    "none published",
                    "mean time below -100 kPa"});
    if (sums[6] > 0.)
      list.push_back(
        {{"injury_pressure_roughness", "-", std::sqrt(sums[5] / sums[6])},
         "well below 1",
         "pressures of elements less their averages, over the "
         "averages: what alternates and is no pressure"});
    list.push_back({{"injury_strain_95", "-", strain},
                    "0.19: half of mild injuries (Zhang et al. 2004, "
                    "recalled)",
                    model});
    list.push_back({{"injury_csdm_15", "-", sums[1] / volume},
                    "0.55 (SIMon 2003, recalled)",
                    model});
    list.push_back({{"injury_csdm_25", "-", sums[2] / volume},
                    "0.54 (SIMon 2008, recalled)",
                    model});
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
  add_pressures(
    mpi::max(peak, communicator), mpi::min(lowest, communicator), list);
  add_parts(sums, percentile(strains, volumes, 0.95, communicator), list);
  return list;
}


InjuryMeasure
head_motion_measure(const std::vector<double> &times,
                    const std::vector<std::array<double, 3>> &velocities,
                    const std::string &motion)
{
  return {{"injury_hic15",
           "-",
           head_injury_criterion(times, velocities, 0.015).value},
          "700 (road traffic), 250 (NATO AEP-55)",
          "of " + motion};
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
  return {{"injury_bric", "-", brain_injury_criterion(largest)},
          "1.0: half of injuries of degree 4 (Takhounts et al. 2013)",
          "of " + motion};
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

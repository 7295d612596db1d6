// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/body/stress_invariants.h>
#include <contrecoup/solid/body/tissue_measures.h>
#include <contrecoup/solid/injury/injury_report.h>

namespace contrecoup::solid
{
template <typename Real>
std::vector<NamedValue>
InjuryReport<Real>::history(const SolidBody<Real> &body) const
{
  if (!active_)
    return {};
  std::vector<double> strains(record_.samples.size()),
    pressures(record_.samples.size());
  body.elements().visit(
    body.nodes(),
    body.times(),
    [&](const std::uint32_t cell, const ElementValues &element) {
      const std::uint32_t i = sample_of_element_[cell];
      strains[i] = largest_principal(element.strain);
      pressures[i] = pressure_of(element.stress);
    },
    brain_);
  if (averaged_)
    pressures = average_.average(pressures);
  std::vector<double> volumes;
  for (const BrainSample &sample : record_.samples)
    volumes.push_back(sample.volume);
  const MPI_Comm communicator = body.communicator();
  if (dealii::Utilities::MPI::sum(volumes.size(), communicator) == 0)
    return {};
  const auto percentile_below = [&](const std::vector<double> &values,
                                    const double below) {
    return percentile(values, volumes, below, communicator);
  };
  return {{"brain_strain_95", "-", percentile_below(strains, 0.95)},
          {"brain_pressure_95", "Pa", percentile_below(pressures, 0.95)},
          {"brain_pressure_5", "Pa", percentile_below(pressures, 0.05)}};
}


template std::vector<NamedValue>
InjuryReport<double>::history(const SolidBody<double> &) const;
template std::vector<NamedValue>
InjuryReport<float>::history(const SolidBody<float> &) const;
} // namespace contrecoup::solid

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
  std::vector<double> strains(record_.pieces.size()),
    pressures(record_.pieces.size());
  body.elements().visit(
    body.nodes(),
    body.times(),
    [&](const std::uint32_t cell, const ElementValues &element) {
      const std::uint32_t i = piece_of_cell_[cell];
      strains[i] = largest_principal(element.strain);
      pressures[i] = pressure_of(element.stress);
    },
    brain_);
  if (averaged_)
    pressures = average_.average(pressures);
  std::vector<double> volumes;
  for (const BrainPiece &piece : record_.pieces)
    volumes.push_back(piece.volume);
  const MPI_Comm communicator = body.communicator();
  if (dealii::Utilities::MPI::sum(volumes.size(), communicator) == 0)
    return {};
  const auto part = [&](const std::vector<double> &values, const double below) {
    return percentile(values, volumes, below, communicator);
  };
  return {{"brain_strain_95", "-", part(strains, 0.95)},
          {"brain_pressure_95", "Pa", part(pressures, 0.95)},
          {"brain_pressure_5", "Pa", part(pressures, 0.05)}};
}


template std::vector<NamedValue>
InjuryReport<double>::history(const SolidBody<double> &) const;
template std::vector<NamedValue>
InjuryReport<float>::history(const SolidBody<float> &) const;
} // namespace contrecoup::solid

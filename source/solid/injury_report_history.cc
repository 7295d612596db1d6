// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/head_injury.h>
#include <contrecoup/solid/injury_report.h>
#include <contrecoup/solid/solid_probes.h>

namespace contrecoup::solid
{
template <typename Real>
std::vector<NamedValue>
InjuryReport<Real>::history(const SolidBody<Real> &body) const
{
  std::vector<double> strains(pieces_.size()), pressures(pieces_.size());
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
  std::vector<double> own_volumes;
  for (const Piece &piece : pieces_)
    own_volumes.push_back(piece.volume);
  const auto gather = [&](const std::vector<double> &mine) {
    std::vector<double> all;
    for (const auto &rank :
         dealii::Utilities::MPI::all_gather(body.communicator(), mine))
      all.insert(all.end(), rank.begin(), rank.end());
    return all;
  };
  const std::vector<double> volumes = gather(own_volumes);
  if (volumes.empty())
    return {};
  const std::vector<double> all_strains = gather(strains),
                            all_pressures = gather(pressures);
  return {
    {"brain_strain_95", "-", weighted_percentile(all_strains, volumes, 0.95)},
    {"brain_pressure_95",
     "Pa",
     weighted_percentile(all_pressures, volumes, 0.95)},
    {"brain_pressure_5",
     "Pa",
     weighted_percentile(all_pressures, volumes, 0.05)}};
}


template std::vector<NamedValue>
InjuryReport<double>::history(const SolidBody<double> &) const;
template std::vector<NamedValue>
InjuryReport<float>::history(const SolidBody<float> &) const;
} // namespace contrecoup::solid

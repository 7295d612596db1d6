// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/motion/solid_operator.h>

#include <algorithm>

/**
 * @file
 * The element loop shared by the sources of SolidOperator.
 */

namespace contrecoup::solid
{
/// Number of batches whose losses are summed in Real before they are added in
/// double.
inline constexpr unsigned int batches_at_once = 32;

/// Sum over all lanes in double.
template <typename Real>
double sum_of(const Lanes<Real> &values)
{
  double sum = 0.;
  for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
    sum += static_cast<double>(values[lane]);
  return sum;
}

/// Minimum over all lanes and zero.
template <typename Real>
double least_of(const Lanes<Real> &values)
{
  double least = 0.;
  for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
    least = std::min(least, static_cast<double>(values[lane]));
  return least;
}


template <typename Real>
template <bool viscoelastic, typename Forces>
void SolidOperator<Real>::add_batches(const Range &range,
                                      NodeFields<Real> &nodes,
                                      const HexModel<Lane> &model,
                                      TissueEnergies &losses,
                                      const Forces &find_forces)
{
  Lane least{};
  const bool has_gas = model.law.gas.exists();
  HexModel<Lane> stiffened = model;
  for (unsigned int first = range.begin; first < range.end;
       first += batches_at_once)
  {
    HexDissipation<Lane> sum;
    const unsigned int last = std::min(first + batches_at_once, range.end);
    for (unsigned int batch = first; batch < last; ++batch)
    {
      if (!batches_.is_active(batch, nodes))
        continue;
      if (has_gas)
        stiffened.law.bulk = secant_bulk(model.law, nodes, batch);
      const unsigned int *offsets = batches_.offsets(batch, 0);
      HexVectors<Lane> x, u;
      HexState<Lane> state;
      state.nodal_average =
        load_corners(nodes.position_and_displacement.data(), offsets, x, u);
      batches_.template load_state<viscoelastic>(range, batch, state);
      HexDissipation<Lane> dissipation;
      const HexVectors<Lane> forces = find_forces(
        has_gas ? stiffened : model, batch, x, u, state, dissipation);
      batches_.template store_state<viscoelastic>(range, batch, state);
      least = std::min(least, state.dilatation);
      subtract_forces(nodes.force.data(), offsets, forces, state.nodal_share);
      sum.bulk_viscosity += dissipation.bulk_viscosity;
      sum.relaxation += dissipation.relaxation;
      sum.hourglass += dissipation.hourglass;
      sum.pressure_smoothing += dissipation.pressure_smoothing;
    }
    losses.bulk_viscosity += sum_of<Real>(sum.bulk_viscosity);
    losses.relaxation += sum_of<Real>(sum.relaxation);
    losses.hourglass_damping += sum_of<Real>(sum.hourglass);
    losses.pressure_smoothing += sum_of<Real>(sum.pressure_smoothing);
  }
  least_dilatations_[range.tissue] =
    std::min(least_dilatations_[range.tissue], least_of<Real>(least));
}
} // namespace contrecoup::solid

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/hex_batches.h>

/**
 * @file
 * Values at the corners of a batch, gathered from nodes and scattered to them.
 */

namespace contrecoup::solid
{
/// Gathers positions @p x and displacements @p u of a batch's corners [m] from
/// NodeFields::position_and_displacement. Returns the mean of the corners'
/// average dilatations.
template <typename Real>
inline DEAL_II_ALWAYS_INLINE Lanes<Real>
load_corners(const Real *coordinates,
             const unsigned int *offsets,
             HexVectors<Lanes<Real>> &x,
             HexVectors<Lanes<Real>> &u)
{
  Lanes<Real> averages{};
  constexpr unsigned int n = n_lanes<Real>;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    unsigned int doubled[n];
    for (unsigned int lane = 0; lane < n; ++lane)
      doubled[lane] = 2 * offsets[n * corner + lane];
    Lanes<Real> values[NodeFields<Real>::position_width];
    dealii::vectorized_load_and_transpose(
      NodeFields<Real>::position_width, coordinates, doubled, values);
    for (unsigned int d = 0; d < 3; ++d)
    {
      x[corner][d] = values[d];
      u[corner][d] = values[3 + d];
    }
    averages += values[6];
  }
  return Real(0.125) * averages;
}

/// Gathers four numbers per corner from NodeFields::force or velocity.
template <typename Real>
inline DEAL_II_ALWAYS_INLINE void
load_vectors(const Real *values,
             const unsigned int *offsets,
             std::array<std::array<Lanes<Real>, 4>, 8> &result)
{
  constexpr unsigned int n = n_lanes<Real>;
  for (unsigned int corner = 0; corner < 8; ++corner)
    dealii::vectorized_load_and_transpose(
      4, values, offsets + n * corner, result[corner].data());
}

/// Subtracts the internal forces of a batch from its nodes' forces, and adds
/// its share of average dilatations to the fourth entries.
template <typename Real>
inline DEAL_II_ALWAYS_INLINE void
subtract_forces(Real *force,
                const unsigned int *offsets,
                const HexVectors<Lanes<Real>> &internal,
                const Lanes<Real> &nodal_share)
{
  constexpr unsigned int n = n_lanes<Real>;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    Lanes<Real> values[4];
    for (unsigned int d = 0; d < 3; ++d)
      values[d] = -internal[corner][d];
    values[3] = nodal_share;
    // One lane after the other, because lanes may share a node.
    dealii::vectorized_transpose_and_store(
      true, 4, values, offsets + n * corner, force);
  }
}
} // namespace contrecoup::solid

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/element/hex8_wedge.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::ale
{
/// Numbers per node in nodal fields.
constexpr unsigned int node_width = 4;

/// The vector of a node in a nodal field.
inline dealii::Tensor<1, 3>
vector_at(const dealii::AlignedVector<double> &field, const std::uint32_t node)
{
  const double *const values = &field[node_width * node];
  return dealii::Tensor<1, 3>({values[0], values[1], values[2]});
}

/// Nodal and cell variables of a rank: owned entries first, then ghost copies.
struct AleState
{
  dealii::AlignedVector<double> position; ///< x, y, z, 0 [m]
  /// v_x, v_y, v_z [m/s], 1 / mass [1/kg]
  dealii::AlignedVector<double> velocity;

  dealii::AlignedVector<double> mass;   ///< by cell [kg]
  dealii::AlignedVector<double> energy; ///< internal energy by cell [J]
  /// mass fraction of explosive products by cell [-]
  dealii::AlignedVector<double> products;

  /// Relaxed strains of viscoelastic solids [-]: component k of cell c is at k
  /// times the number of cells plus c; empty without relaxation.
  dealii::AlignedVector<double> relaxed;

  double time = 0.; ///< [s]

  /// Wedge of an axisymmetric mesh; inactive for a mesh of the whole. In a
  /// wedge, initial nodal masses are weighted by trilinear shape functions;
  /// otherwise each node gets an eighth of each adjacent cell's mass.
  HexWedge wedge;
};
} // namespace contrecoup::ale

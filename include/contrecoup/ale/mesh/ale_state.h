// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/hex8_wedge.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::ale
{
/// What nodes and cells of a rank carry, copies of those of other ranks behind
/// the own ones.
struct AleState
{
  /// Numbers at each node.
  static constexpr unsigned int width = 4;

  dealii::AlignedVector<double> position; ///< x, y, z, 0 [m]
  dealii::AlignedVector<double> velocity; ///< three [m/s], 1 / mass [1/kg]

  dealii::AlignedVector<double> mass;     ///< of each cell [kg]
  dealii::AlignedVector<double> energy;   ///< internal, of each cell [J]
  dealii::AlignedVector<double> products; ///< mass fraction in each cell [-]

  /// Strains of the relaxing branches of solids in each cell: six numbers, each
  /// of all cells after the other; empty where nothing relaxes [-].
  dealii::AlignedVector<double> relaxed;

  double time = 0.; ///< [s]

  /// That the mesh is. Masses of its nodes are those around them by trilinear
  /// functions at the start, without it eighths of cells.
  HexWedge wedge;
};
} // namespace contrecoup::ale

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <cstddef>
#include <vector>

namespace contrecoup::solid
{
/**
 * Positions, displacements, velocities, forces and masses of nodes. Storing
 * displacements instead of current coordinates avoids cancellation in single
 * precision. Position and displacement form one array of 8 numbers per node,
 * which kernels load at once; forces and velocities are arrays of 4.
 */
template <typename Real>
struct NodeFields
{
  static constexpr unsigned int position_width = 8;
  static constexpr unsigned int width = 4;

  dealii::AlignedVector<Real>
    position_and_displacement; ///< x, y, z, u_x, u_y, u_z [m], see below
  /// f_x, f_y, f_z [N], and the sum of the elements' volumes times dilatations,
  /// which move_nodes() makes an average
  dealii::AlignedVector<Real> force;
  /// v_x, v_y, v_z [m/s], 1 / mass [1/kg]
  dealii::AlignedVector<Real> velocity;

  /// Number of nodes in a block of `active`.
  static constexpr std::size_t block = 64;
  /// Whether any node of a block was ever displaced or had an initial
  /// velocity. Elements of other blocks have no forces and zero history.
  std::vector<unsigned char> active;

  /// Sizes all fields for @p n_nodes nodes and sets them to zero.
  void reinit(const std::size_t n_nodes)
  {
    position_and_displacement.resize(position_width * n_nodes);
    force.resize(width * n_nodes);
    velocity.resize(width * n_nodes);
    position_and_displacement.fill(Real());
    force.fill(Real());
    velocity.fill(Real());
    active.assign(n_nodes / block + 1, 0);
  }

  /// Marks the blocks of all nodes with a displacement or velocity.
  void mark_active_blocks()
  {
    for (std::size_t i = 0; i < size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
        if (displacement_of(i)[d] != Real() || velocity_of(i)[d] != Real())
          active[i / block] = 1;
  }

  std::size_t size() const
  {
    return force.size() / width;
  }

  Real *displacement_of(const std::size_t node)
  {
    return &position_and_displacement[position_width * node + 3];
  }
  const Real *displacement_of(const std::size_t node) const
  {
    return &position_and_displacement[position_width * node + 3];
  }
  /// The average around a node of S of PressureSmoothing.
  Real &average_dilatation_of(const std::size_t node)
  {
    return position_and_displacement[position_width * node + 6];
  }
  /// Factor from the sum of shares to average_dilatation_of() [1/m^3].
  Real &inverse_weight_of(const std::size_t node)
  {
    return position_and_displacement[position_width * node + 7];
  }
  Real *force_of(const std::size_t node)
  {
    return &force[width * node];
  }
  const Real *force_of(const std::size_t node) const
  {
    return &force[width * node];
  }
  Real *velocity_of(const std::size_t node)
  {
    return &velocity[width * node];
  }
  const Real *velocity_of(const std::size_t node) const
  {
    return &velocity[width * node];
  }
  Real &inverse_mass_of(const std::size_t node)
  {
    return velocity[width * node + 3];
  }
  const Real &inverse_mass_of(const std::size_t node) const
  {
    return velocity[width * node + 3];
  }
};
} // namespace contrecoup::solid

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
 * What nodes carry. Displacements are stored, not coordinates, so that their
 * digits are not lost in single precision. A node has 8 numbers in one place,
 * which kernels load at once, and twice 4 in others.
 */
template <typename Real>
struct NodeFields
{
  static constexpr unsigned int place_width = 8;
  static constexpr unsigned int width = 4;

  dealii::AlignedVector<Real> place;    ///< x, y, z, u_x, u_y, u_z, 0, 0 [m]
  dealii::AlignedVector<Real> force;    ///< three components, 0 [N]
  dealii::AlignedVector<Real> velocity; ///< three [m/s], 1 / mass [1/kg]

  /// Nodes in a block of `awake`.
  static constexpr std::size_t block = 64;
  /// Whether any node of a block was ever displaced, or began with a velocity:
  /// elsewhere elements have no forces and no memory.
  std::vector<unsigned char> awake;

  /// All zero, for @p n_nodes.
  void reinit(const std::size_t n_nodes)
  {
    place.resize(place_width * n_nodes);
    force.resize(width * n_nodes);
    velocity.resize(width * n_nodes);
    place.fill(Real());
    force.fill(Real());
    velocity.fill(Real());
    awake.assign(n_nodes / block + 1, 0);
  }

  /// Looks for all nodes that are displaced or have a velocity.
  void find_awake()
  {
    for (std::size_t i = 0; i < size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
        if (displacement_of(i)[d] != Real() || velocity_of(i)[d] != Real())
          awake[i / block] = 1;
  }

  std::size_t size() const
  {
    return force.size() / width;
  }

  Real *displacement_of(const std::size_t node)
  {
    return &place[place_width * node + 3];
  }
  const Real *displacement_of(const std::size_t node) const
  {
    return &place[place_width * node + 3];
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

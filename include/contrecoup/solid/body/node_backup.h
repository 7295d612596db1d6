// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/node_fields.h>

#include <algorithm>
#include <vector>

namespace contrecoup::solid
{
/// A copy of the node fields that time steps change: displacements, velocities
/// and forces, but not positions and masses.
template <typename Real>
class NodeBackup
{
public:
  void save(const NodeFields<Real> &nodes)
  {
    numbers_.resize(width * nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      Real *next = &numbers_[width * i];
      next = std::copy_n(nodes.displacement_of(i), 3, next);
      next = std::copy_n(nodes.velocity_of(i), 3, next);
      std::copy_n(nodes.force_of(i), 4, next);
    }
    active_ = nodes.active;
  }

  /// @param nodes has the size that keep() saw
  void restore(NodeFields<Real> &nodes) const
  {
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      const Real *from = &numbers_[width * i];
      std::copy_n(from, 3, nodes.displacement_of(i));
      std::copy_n(from + 3, 3, nodes.velocity_of(i));
      std::copy_n(from + 6, 4, nodes.force_of(i));
    }
    nodes.active = active_;
  }

  std::size_t memory_consumption() const
  {
    return numbers_.capacity() * sizeof(Real) + active_.capacity();
  }

private:
  static constexpr unsigned int width = 10;

  std::vector<Real> numbers_;
  std::vector<unsigned char> active_;
};
} // namespace contrecoup::solid

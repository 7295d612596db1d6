// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/boundary.h>
#include <contrecoup/gas/octree/leaf_mesh.h>
#include <contrecoup/gas/state/gas_field.h>

#include <array>
#include <iosfwd>
#include <limits>
#include <vector>

namespace contrecoup::gas
{
/**
 * Watches when a blast reaches the open sides of a box: when the overpressure
 * in a leaf there first exceeds BlastRecord::threshold of the ambient pressure,
 * up to `interval` steps late.
 */
template <int dim>
class OpenSides
{
public:
  static constexpr unsigned int interval = 8;

  OpenSides()
  {
    arrivals_.fill(never);
  }

  /// The sides of @p mesh that are open. Call when the mesh changed.
  void reinit(const LeafMesh<dim> &mesh, const Boundary<dim> &boundary);

  /// Looks at the gas at @p time [s].
  void watch(const GasField &field,
             const GasMaterial &material,
             const double ambient_pressure,
             const double time);

  /// Makes the arrivals the same on all ranks. Collective.
  void share(const MPI_Comm communicator);

  /// By side, 2 d and 2 d + 1 at the low and high end of direction d; time of
  /// arrival [s], or `never`.
  const std::array<double, 2 * dim> &arrivals() const
  {
    return arrivals_;
  }

  static constexpr double never = std::numeric_limits<double>::max();

  /// The arrivals, for checkpoints, after share().
  void save(std::ostream &stream) const;
  void load(std::istream &stream);

private:
  /// Leaves at open sides, by side.
  std::array<std::vector<unsigned int>, 2 * dim> leaves_;
  std::array<double, 2 * dim> arrivals_;
};
} // namespace contrecoup::gas

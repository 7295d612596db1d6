// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/node_fields.h>
#include <contrecoup/solid/body/solid_mesh.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <vector>

namespace contrecoup::solid
{
/**
 * The outer facets whose middles are within a radius of a place, and how fast
 * they move into the body.
 */
class SurfacePatch
{
public:
  /// Takes the nearest facet alone where none is within @p radius [m].
  /// Collective.
  void reinit(const SolidMesh &mesh,
              const dealii::Point<3> &place,
              double radius,
              MPI_Comm communicator);

  /// Mean over the area of the velocity against the outer normal of the
  /// undeformed surface [m/s]; 0 without any surface. Collective.
  template <typename Real>
  double inward_velocity(const NodeFields<Real> &nodes) const;

  /// Of all ranks [m^2].
  double area() const
  {
    return area_;
  }

private:
  /// A facet of this rank with its area vector, outwards [m^2].
  struct Facet
  {
    std::array<std::uint32_t, 4> nodes;
    dealii::Tensor<1, 3> area;
  };

  std::vector<Facet> facets_;
  double area_ = 0.;
  MPI_Comm communicator_ = MPI_COMM_SELF;
};
} // namespace contrecoup::solid

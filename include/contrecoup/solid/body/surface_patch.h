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
/// The boundary facets whose centres lie within a radius of a point, and their
/// mean inward velocity.
class SurfacePatch
{
public:
  /// Selects the facets. Without any within @p radius [m], the nearest facet
  /// is selected alone. Collective.
  void reinit(const SolidMesh &mesh,
              const dealii::Point<3> &place,
              double radius,
              MPI_Comm communicator);

  /// Area-weighted mean of the velocity against the outer normal of the
  /// undeformed surface [m/s]; 0 without boundary facets. Collective.
  template <typename Real>
  double inward_velocity(const NodeFields<Real> &nodes) const;

  /// Distance of the nearest facet's centre from the point [m].
  double distance() const
  {
    return distance_;
  }

  /// Mean edge of the facets [m].
  double facet_edge() const
  {
    return facet_edge_;
  }

  /// Area of the patch on all ranks [m^2].
  double area() const
  {
    return area_;
  }

private:
  /// A facet of this rank with its outward area vector [m^2].
  struct Facet
  {
    std::array<std::uint32_t, 4> nodes;
    dealii::Tensor<1, 3> area;
  };

  std::vector<Facet> facets_;
  double area_ = 0.;
  double distance_ = 0.;
  double facet_edge_ = 0.;
  MPI_Comm communicator_ = MPI_COMM_SELF;
};
} // namespace contrecoup::solid

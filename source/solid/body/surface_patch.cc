// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/body/surface_patch.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::solid
{
namespace
{
  using dealii::Point;
  using dealii::Tensor;

  Point<3> middle_of(const SolidMesh &mesh, const HexMesh::Facet &facet)
  {
    Point<3> sum;
    for (const std::uint32_t node : facet.nodes)
      sum += mesh.nodes[node];
    return Point<3>(sum / 4.);
  }
} // namespace


void SurfacePatch::reinit(const SolidMesh &mesh,
                          const Point<3> &place,
                          const double radius,
                          const MPI_Comm communicator)
{
  communicator_ = communicator;
  facets_.clear();
  double nearest = std::numeric_limits<double>::max();
  for (const HexMesh::Facet &facet : mesh.boundary)
    nearest = std::min(nearest, middle_of(mesh, facet).distance(place));
  nearest = dealii::Utilities::MPI::min(nearest, communicator);
  const double limit = std::max(radius, nearest * (1. + 1e-6));
  area_ = 0.;
  for (const HexMesh::Facet &facet : mesh.boundary)
    if (middle_of(mesh, facet).distance(place) <= limit)
    {
      const auto &corner = facet.nodes;
      const Tensor<1, 3> area =
        0.5 * cross_product_3d(mesh.nodes[corner[2]] - mesh.nodes[corner[0]],
                               mesh.nodes[corner[3]] - mesh.nodes[corner[1]]);
      facets_.push_back({corner, area});
      area_ += area.norm();
    }
  area_ = dealii::Utilities::MPI::sum(area_, communicator);
  const auto n_facets = static_cast<double>(
    dealii::Utilities::MPI::sum(facets_.size(), communicator));
  distance_ = nearest;
  facet_edge_ = n_facets > 0. ? std::sqrt(area_ / n_facets) : 0.;
}


template <typename Real>
double SurfacePatch::inward_velocity(const NodeFields<Real> &nodes) const
{
  double flow = 0.;
  for (const Facet &facet : facets_)
    for (const std::uint32_t node : facet.nodes)
      for (unsigned int d = 0; d < 3; ++d)
        flow -= 0.25 * facet.area[d] * double(nodes.velocity_of(node)[d]);
  flow = dealii::Utilities::MPI::sum(flow, communicator_);
  return area_ > 0. ? flow / area_ : 0.;
}


template double SurfacePatch::inward_velocity(const NodeFields<double> &) const;
template double SurfacePatch::inward_velocity(const NodeFields<float> &) const;
} // namespace contrecoup::solid

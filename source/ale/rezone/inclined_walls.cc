// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/boundary_areas.h>
#include <contrecoup/ale/rezone/inclined_walls.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::ale
{
InclinedWalls::InclinedWalls(
  const HexSpace &space,
  const dealii::AlignedVector<double> &position,
  const std::vector<dealii::types::boundary_id> &boundaries,
  const std::function<bool(const HexSpace::Face &)> &is_inclined)
  : position_(position)
{
  for (const auto boundary : boundaries)
  {
    int found = 0;
    for (const HexSpace::Face &face : space.faces())
      if (face.outside == HexSpace::no_cell && face.boundary == boundary &&
          is_inclined(face))
        found = 1;
    if (dealii::Utilities::MPI::max(found, space.communicator()) == 0)
      continue;
    numbers_[boundary] = size();
    normals_.push_back(boundary_areas(
      space, position, [boundary](const dealii::types::boundary_id other) {
        return other == boundary;
      }));
    for (auto &normal : normals_.back())
      if (normal.norm() > 0.)
        normal /= normal.norm();
  }
}


unsigned int InclinedWalls::wall_around(const HexSpace::Face &face,
                                        const unsigned int corner) const
{
  // Relative round-off of a small cell far from the origin.
  constexpr double tolerance = 1e-9;
  const auto found = numbers_.find(face.boundary);
  if (face.outside != HexSpace::no_cell || found == numbers_.end())
    return none;
  const auto &normal = normals_[found->second][face.nodes[corner]];
  for (const std::uint32_t node : face.nodes)
  {
    dealii::Tensor<1, 3> way;
    for (unsigned int d = 0; d < 3; ++d)
      way[d] = position_[node_width * node + d] -
               position_[node_width * face.nodes[corner] + d];
    if (std::abs(way * normal) > tolerance * way.norm())
      return none;
  }
  return found->second;
}


void InclinedWalls::add_node(const std::uint32_t node,
                             const double *is_along,
                             std::array<bool, 3> &is_prescribed,
                             std::vector<InclinedNode> &inclined) const
{
  // Gauss-Jordan elimination of normal * displacement = 0, for displacements
  // relative to the matter.
  std::vector<std::pair<unsigned int, dealii::Tensor<1, 3>>> rows;
  for (unsigned int wall = 0; wall < size(); ++wall)
  {
    if (!(is_along[wall] > 0.))
      continue;
    auto row = normals_[wall][node];
    for (unsigned int d = 0; d < 3; ++d)
      if (is_prescribed[d])
        row[d] = 0.;
    for (const auto &[pivot, other] : rows)
      row -= row[pivot] * other;
    // The same tolerance as in SlipWalls.
    if (row.norm() < 1e-6)
      continue;
    unsigned int pivot = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(row[d]) > std::abs(row[pivot]))
        pivot = d;
    row /= row[pivot];
    for (auto &[unused, other] : rows)
      other -= other[pivot] * row;
    rows.emplace_back(pivot, row);
  }
  for (const auto &[pivot, row] : rows)
  {
    InclinedNode slide;
    slide.node = node;
    slide.component = pivot;
    bool follows = false;
    for (unsigned int d = 0; d < 3; ++d)
      if (d != pivot && std::abs(row[d]) > 1e-12)
      {
        slide.factor[d] = -row[d];
        follows = true;
      }
    if (follows)
      inclined.push_back(slide);
    else
      is_prescribed[pivot] = true;
  }
}
} // namespace contrecoup::ale

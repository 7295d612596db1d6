// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/boundary_areas.h>
#include <contrecoup/ale/mesh/slip_walls.h>

#include <algorithm>
#include <array>

namespace contrecoup::ale
{
void SlipWalls::reinit(
  const HexSpace &space,
  const dealii::AlignedVector<double> &position,
  const std::map<dealii::types::boundary_id, Motion> &walls)
{
  twins_.clear();
  motions_.clear();
  wall_nodes_.clear();
  std::map<std::uint32_t, std::vector<WallNode>> of_node;
  for (const auto &[boundary, motion] : walls)
  {
    add_wall(space, position, boundary, motions_.size(), of_node);
    motions_.push_back(motion);
  }
  for (const auto &[node, list] : of_node)
    wall_nodes_.insert(wall_nodes_.end(), list.begin(), list.end());
}


void SlipWalls::mirror(const HexSpace &space, const HexWedge &wedge)
{
  wedge_ = wedge;
  twins_.clear();
  if (!wedge.active())
    return;
  constexpr unsigned int opposite[][2] = {{0, 3}, {1, 2}, {4, 7}, {5, 6}};
  for (std::size_t c = 0; c < space.n_cells(); ++c)
    for (const auto &pair : opposite)
      twins_.emplace_back(space.cell(c)[pair[0]], space.cell(c)[pair[1]]);
  std::sort(twins_.begin(), twins_.end());
  twins_.erase(std::unique(twins_.begin(), twins_.end()), twins_.end());
}


void SlipWalls::make_mirrored(dealii::AlignedVector<double> &field) const
{
  for (const auto &[first, second] : twins_)
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double sign = d == wedge_.side() ? -1. : 1.;
      double &a = field[node_width * first + d];
      double &b = field[node_width * second + d];
      a = 0.5 * (a + sign * b);
      b = sign * a;
    }
}


void SlipWalls::add_wall(
  const HexSpace &space,
  const dealii::AlignedVector<double> &position,
  const dealii::types::boundary_id boundary,
  const unsigned int wall,
  std::map<std::uint32_t, std::vector<WallNode>> &of_node) const
{
  const auto areas = boundary_areas(
    space, position, [&](const dealii::types::boundary_id other) {
      return other == boundary;
    });
  for (std::uint32_t node = 0; node < areas.size(); ++node)
    if (areas[node].norm() > 0.)
      of_node[node].push_back({node, areas[node] / areas[node].norm(), wall});
}


void SlipWalls::apply(dealii::AlignedVector<double> &velocity,
                      const double time) const
{
  std::vector<double> speed(motions_.size());
  for (std::size_t i = 0; i < motions_.size(); ++i)
    speed[i] = motions_[i](time);
  set_normal_parts(velocity, speed);
}


void SlipWalls::remove_normal_parts(dealii::AlignedVector<double> &field) const
{
  set_normal_parts(field, std::vector<double>(motions_.size(), 0.));
}


void SlipWalls::set_normal_parts(dealii::AlignedVector<double> &velocity,
                                 const std::vector<double> &speed) const
{
  std::size_t begin = 0;
  while (begin < wall_nodes_.size())
  {
    const std::uint32_t node = wall_nodes_[begin].node;
    // Gram-Schmidt orthogonalisation of the normals of a node's walls.
    std::array<dealii::Tensor<1, 3>, 3> fixed;
    std::array<double, 3> value{};
    unsigned int n_fixed = 0;
    std::size_t i = begin;
    for (; i < wall_nodes_.size() && wall_nodes_[i].node == node; ++i)
    {
      dealii::Tensor<1, 3> normal = wall_nodes_[i].normal;
      double normal_speed = speed[wall_nodes_[i].wall];
      for (unsigned int k = 0; k < n_fixed; ++k)
      {
        const double part = wall_nodes_[i].normal * fixed[k];
        normal -= part * fixed[k];
        normal_speed -= part * value[k];
      }
      const double size = normal.norm();
      if (n_fixed == 3 || size < 1e-6)
        continue;
      fixed[n_fixed] = normal / size;
      value[n_fixed] = normal_speed / size;
      ++n_fixed;
    }
    double *v = &velocity[node_width * node];
    for (unsigned int k = 0; k < n_fixed; ++k)
    {
      double difference = value[k];
      for (unsigned int d = 0; d < 3; ++d)
        difference -= v[d] * fixed[k][d];
      for (unsigned int d = 0; d < 3; ++d)
        v[d] += difference * fixed[k][d];
    }
    begin = i;
  }
  make_mirrored(velocity);
}
} // namespace contrecoup::ale

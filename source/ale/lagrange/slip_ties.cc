// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/slip_ties.h>
#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/boundary_areas.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace contrecoup::ale
{
void SlipTies::reinit(const HexSpace &space)
{
  space_ = &space;
  faces_.clear();
  const auto &pairs = space.sliding_pairs();
  normals_.assign(pairs.size(), dealii::Tensor<1, 3>());
  impulses_ = normals_;
  is_empty_ = dealii::Utilities::MPI::max(pairs.empty() ? 0 : 1,
                                          space.communicator()) == 0;
  if (is_empty_)
    return;
  exchange_.reinit(space.nodes(), node_width);
  areas_.resize(exchange_.size());
  std::vector<std::uint32_t> held(space.n_nodes());
  for (std::uint32_t node = 0; node < held.size(); ++node)
    held[node] = node;
  for (const HexSpace::SlidingPair &pair : pairs)
    held[pair.sliding] = pair.held;
  for (const HexSpace::Face &face : space.faces())
    if (space.is_sliding(face) && face.inside < space.n_locally_owned_cells())
    {
      faces_.push_back({{}, space.slides(face.inside) ? 1. : -1.});
      for (unsigned int i = 0; i < 4; ++i)
        faces_.back().nodes[i] = held[face.nodes[i]];
    }
}


void SlipTies::find_normals(const dealii::AlignedVector<double> &position,
                            const SlipWalls &walls)
{
  if (is_empty_)
    return;
  areas_.fill(0.);
  for (const Face &face : faces_)
  {
    const auto area = face.sign * area_vector(face.nodes, position);
    for (const std::uint32_t node : face.nodes)
      for (unsigned int d = 0; d < 3; ++d)
        areas_[node_width * node + d] += 0.25 * area[d];
  }
  exchange_.compress_add(areas_);
  exchange_.update_ghost_values(areas_);
  walls.remove_normal_parts(areas_);
  for (std::size_t i = 0; i < normals_.size(); ++i)
  {
    const double *const area =
      &areas_[node_width * space_->sliding_pairs()[i].held];
    const dealii::Tensor<1, 3> normal({area[0], area[1], area[2]});
    const double size = normal.norm();
    normals_[i] = size > 0. ? normal / size : dealii::Tensor<1, 3>();
  }
}


void SlipTies::apply(dealii::AlignedVector<double> &velocity)
{
  for (std::size_t i = 0; i < normals_.size(); ++i)
  {
    const auto [sliding, held] = space_->sliding_pairs()[i];
    double *const v = &velocity[node_width * sliding];
    double *const w = &velocity[node_width * held];
    double difference = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      difference += normals_[i][d] * (w[d] - v[d]);
    impulses_[i] = difference / (v[3] + w[3]) * normals_[i];
    for (unsigned int d = 0; d < 3; ++d)
    {
      v[d] += v[3] * impulses_[i][d];
      w[d] -= w[3] * impulses_[i][d];
    }
  }
}


double SlipTies::work(const dealii::AlignedVector<double> &mean) const
{
  double result = 0.;
  for (std::size_t i = 0; i < impulses_.size(); ++i)
  {
    const auto [sliding, held] = space_->sliding_pairs()[i];
    if (sliding < space_->n_locally_owned_nodes())
      for (unsigned int d = 0; d < 3; ++d)
        result += impulses_[i][d] * (mean[node_width * sliding + d] -
                                     mean[node_width * held + d]);
  }
  return result;
}


double SlipTies::largest_slip_speed(
  const dealii::AlignedVector<double> &velocity) const
{
  double largest = 0.;
  for (const auto &[sliding, held] : space_->sliding_pairs())
  {
    double square = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      square += std::pow(velocity[node_width * sliding + d] -
                           velocity[node_width * held + d],
                         2);
    largest = std::max(largest, std::sqrt(square));
  }
  return dealii::Utilities::MPI::max(largest, space_->communicator());
}
} // namespace contrecoup::ale

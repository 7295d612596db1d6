// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/body/nodal_average.h>

namespace contrecoup::solid
{
void NodalAverage::reinit(std::vector<Corners> corners,
                          std::vector<double> volumes,
                          const std::size_t n_nodes,
                          AddRanks add_ranks)
{
  add_ranks_ = std::move(add_ranks);
  n_mesh_nodes_ = n_nodes;
  corner_indices_ = std::move(corners);
  volumes_ = std::move(volumes);
  nodes_.clear();
  std::vector<std::uint32_t> index(n_nodes, no_index);
  for (Corners &corners_of_one : corner_indices_)
    for (std::uint32_t &node : corners_of_one)
    {
      if (index[node] == no_index)
      {
        index[node] = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back(node);
      }
      node = index[node];
    }
  inverse_volumes_ =
    nodal_sums(std::vector<double>(corner_indices_.size(), 1.));
  for (double &value : inverse_volumes_)
    value = 1. / value;
}


std::vector<double>
NodalAverage::nodal_sums(const std::vector<double> &values) const
{
  std::vector<double> sums(nodes_.size(), 0.);
  for (std::size_t i = 0; i < corner_indices_.size(); ++i)
    for (const std::uint32_t node : corner_indices_[i])
      sums[node] += volumes_[i] * values[i];
  if (!add_ranks_)
    return sums;
  dealii::AlignedVector<double> all(n_mesh_nodes_);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    all[nodes_[i]] = sums[i];
  add_ranks_(all);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    sums[i] = all[nodes_[i]];
  return sums;
}


std::vector<double>
NodalAverage::average(const std::vector<double> &values) const
{
  std::vector<double> at_nodes = nodal_sums(values);
  for (std::size_t i = 0; i < at_nodes.size(); ++i)
    at_nodes[i] *= inverse_volumes_[i];
  std::vector<double> result(corner_indices_.size(), 0.);
  for (std::size_t i = 0; i < corner_indices_.size(); ++i)
    for (const std::uint32_t node : corner_indices_[i])
      result[i] += at_nodes[node] / 8.;
  return result;
}
} // namespace contrecoup::solid

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/hex8_geometry.h>
#include <contrecoup/solid/tissue_average.h>

namespace contrecoup::solid
{
void TissueAverage::reinit(const SolidMesh &mesh,
                           const NodeExchange &exchange,
                           const unsigned int tissue)
{
  exchange_ = &exchange;
  n_mesh_nodes_ = mesh.nodes.size();
  alone_ = mesh.neighbors.empty();
  cells_.clear();
  volumes_.clear();
  nodes_.clear();
  at_.clear();
  constexpr std::uint32_t none = -1;
  std::vector<std::uint32_t> place(mesh.nodes.size(), none);
  for (std::uint32_t i = 0; i < mesh.cells.size(); ++i)
  {
    if (mesh.tissue[i] != tissue)
      continue;
    cells_.push_back(i);
    HexVectors<double> x;
    std::array<std::uint32_t, 8> at;
    for (unsigned int c = 0; c < 8; ++c)
    {
      const std::uint32_t node = mesh.cells[i][c];
      for (unsigned int d = 0; d < 3; ++d)
        x[c][d] = mesh.nodes[node][d];
      if (place[node] == none)
      {
        place[node] = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back(node);
      }
      at[c] = place[node];
    }
    volumes_.push_back(hex_geometry(to_modes(x)).volume);
    at_.push_back(at);
  }
  inverse_volumes_ = nodal_sums(std::vector<double>(cells_.size(), 1.));
  for (double &value : inverse_volumes_)
    value = 1. / value;
}


std::vector<double>
TissueAverage::nodal_sums(const std::vector<double> &values) const
{
  std::vector<double> sums(nodes_.size(), 0.);
  for (std::size_t i = 0; i < at_.size(); ++i)
    for (const std::uint32_t node : at_[i])
      sums[node] += volumes_[i] * values[i];
  if (alone_)
    return sums;
  std::vector<double> all(n_mesh_nodes_, 0.);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    all[nodes_[i]] = sums[i];
  exchange_->add(all.data(), 1, 1);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    sums[i] = all[nodes_[i]];
  return sums;
}


std::vector<double>
TissueAverage::average(const std::vector<double> &values) const
{
  std::vector<double> at_nodes = nodal_sums(values);
  for (std::size_t i = 0; i < at_nodes.size(); ++i)
    at_nodes[i] *= inverse_volumes_[i];
  std::vector<double> result(at_.size(), 0.);
  for (std::size_t i = 0; i < at_.size(); ++i)
    for (const std::uint32_t node : at_[i])
      result[i] += at_nodes[node] / 8.;
  return result;
}
} // namespace contrecoup::solid

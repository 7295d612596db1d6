// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/body/tissue_average.h>

namespace contrecoup::solid
{
void TissueAverage::reinit(const SolidMesh &mesh,
                           const NodeExchange &exchange,
                           const unsigned int tissue)
{
  elements_.clear();
  std::vector<NodalAverage::Corners> corners;
  std::vector<double> volumes;
  for (std::uint32_t i = 0; i < mesh.elements.size(); ++i)
  {
    if (mesh.tissue[i] != tissue)
      continue;
    elements_.push_back(i);
    volumes.push_back(cell_volume(mesh, i));
    corners.push_back(mesh.elements[i]);
  }
  NodalAverage::AddRanks add_ranks;
  if (!mesh.neighbors.empty())
    add_ranks = [&exchange](dealii::AlignedVector<double> &values) {
      exchange.add(values.data(), 1, 1);
    };
  average_.reinit(std::move(corners),
                  std::move(volumes),
                  mesh.nodes.size(),
                  std::move(add_ranks));
}
} // namespace contrecoup::solid

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/element/hex8_geometry.h>
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
    HexVectors<double> x;
    for (unsigned int c = 0; c < 8; ++c)
      for (unsigned int d = 0; d < 3; ++d)
        x[c][d] = mesh.nodes[mesh.elements[i][c]][d];
    volumes.push_back(hex_geometry(to_modes(x)).volume);
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

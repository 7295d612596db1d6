// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/boundary_areas.h>

namespace contrecoup::ale
{
dealii::Tensor<1, 3> area_vector(const std::array<std::uint32_t, 4> &nodes,
                                 const dealii::AlignedVector<double> &position)
{
  dealii::Tensor<1, 3> first, second;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const auto x = [&](const unsigned int i) {
      return position[node_width * nodes[i] + d];
    };
    first[d] = x(2) - x(0);
    second[d] = x(3) - x(1);
  }
  return 0.5 * dealii::cross_product_3d(first, second);
}


std::vector<dealii::Tensor<1, 3>>
boundary_areas(const HexSpace &space,
               const dealii::AlignedVector<double> &position,
               const std::function<bool(dealii::types::boundary_id)> &is_meant)
{
  FieldExchange exchange;
  exchange.reinit(space.nodes(), 3);
  dealii::AlignedVector<double> areas(exchange.size());
  for (const HexSpace::Face &face : space.faces())
  {
    if (face.outside != HexSpace::no_cell || !is_meant(face.boundary))
      continue;
    const auto area = area_vector(face.nodes, position);
    for (const std::uint32_t node : face.nodes)
      for (unsigned int d = 0; d < 3; ++d)
        areas[3 * node + d] += 0.25 * area[d];
  }
  exchange.compress_add(areas);
  exchange.update_ghost_values(areas);
  std::vector<dealii::Tensor<1, 3>> result(space.n_nodes());
  for (std::size_t node = 0; node < result.size(); ++node)
    for (unsigned int d = 0; d < 3; ++d)
      result[node][d] = areas[3 * node + d];
  return result;
}
} // namespace contrecoup::ale

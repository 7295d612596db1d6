// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/cell_batches.h>

#include <map>

namespace contrecoup::ale
{
void CellBatches::reinit(const HexSpace &space, const unsigned int width)
{
  ranges_.clear();
  offsets_.clear();
  cells_.clear();
  weights_.clear();
  std::map<unsigned int, std::vector<unsigned int>> of_region;
  for (unsigned int c = 0; c < space.n_locally_owned_cells(); ++c)
    of_region[space.region(c)].push_back(c);
  for (const auto &[region, cells] : of_region)
  {
    const unsigned int begin = n_batches();
    add(space, cells, width);
    ranges_.push_back({region, begin, n_batches()});
  }
}


void CellBatches::add(const HexSpace &space,
                      const std::vector<unsigned int> &cells,
                      const unsigned int width)
{
  for (std::size_t first = 0; first < cells.size(); first += n)
  {
    Lane weight(0.);
    const std::size_t begin = cells_.size();
    for (unsigned int lane = 0; lane < n; ++lane)
    {
      const bool is_cell = first + lane < cells.size();
      cells_.push_back(cells[is_cell ? first + lane : first]);
      weight[lane] = is_cell ? 1. : 0.;
    }
    weights_.push_back(weight);
    for (unsigned int corner = 0; corner < 8; ++corner)
      for (unsigned int lane = 0; lane < n; ++lane)
        offsets_.push_back(width * space.cell(cells_[begin + lane])[corner]);
  }
}
} // namespace contrecoup::ale

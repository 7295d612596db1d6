// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/tile_levels.h>

#include <algorithm>

namespace contrecoup::mpm
{
void TileLevels::reinit(const GridBox &box)
{
  box_ = box;
  n_coarse_ = 1;
  for (unsigned int d = 0; d < 3; ++d)
  {
    // Nodes at upper sides belong to tiles as well.
    n_tiles_[d] = box.n_cells[d] / tile_edge + 1;
    n_coarse_ *= n_tiles_[d];
  }
  is_halved_.clear();
}


std::vector<TileLevels::TileId>
TileLevels::blocks_to_halve(const TileId tile) const
{
  std::vector<TileId> result;
  const double edge = block_edge * box_.cell_size;
  for (const TileId block : blocks(tile))
  {
    const auto first = origin(block);
    dealii::Point<3> lower = box_.lower;
    bool is_inside = true;
    for (unsigned int d = 0; d < 3; ++d)
    {
      lower[d] += cell_size(1) * first[d];
      is_inside = is_inside && first[d] < n_cells(1, d);
    }
    if (is_inside && box_.halving.blocks(lower, edge))
      result.push_back(block);
  }
  return result;
}


void TileLevels::set_halved(const std::vector<TileId> &blocks)
{
  is_halved_.clear();
  if (blocks.empty())
    return;
  is_halved_.resize(8 * n_coarse_, false);
  for (const TileId block : blocks)
    is_halved_[block - n_coarse_] = true;
}


TileLevels::TileId TileLevels::tile_of(const std::array<int, 3> &cell,
                                       const unsigned int level) const
{
  TileId id = 0;
  for (int d = 2; d >= 0; --d)
    id = id * (n_tiles_[d] << level) +
         static_cast<unsigned int>(cell[d] / tile_edge);
  return level == 0 ? id : n_coarse_ + id;
}


std::array<int, 3> TileLevels::origin(const TileId tile) const
{
  const unsigned int shift = level(tile);
  const TileId n_x = n_tiles_[0] << shift, n_y = n_tiles_[1] << shift,
               number = shift == 0 ? tile : tile - n_coarse_,
               rest = number / n_x;
  return {{tile_edge * static_cast<int>(number % n_x),
           tile_edge * static_cast<int>(rest % n_y),
           tile_edge * static_cast<int>(rest / n_y)}};
}


TileLevels::TileId TileLevels::coarse(const TileId tile) const
{
  if (level(tile) == 0)
    return tile;
  auto cell = origin(tile);
  for (int &i : cell)
    i /= 2;
  return tile_of(cell, 0);
}


std::array<TileLevels::TileId, 8> TileLevels::blocks(const TileId tile) const
{
  const auto first = origin(tile);
  std::array<TileId, 8> result;
  for (int i = 0; i < 8; ++i)
    result[i] = tile_of({{2 * first[0] + tile_edge * (i & 1),
                          2 * first[1] + tile_edge * (i >> 1 & 1),
                          2 * first[2] + tile_edge * (i >> 2)}},
                        1);
  return result;
}


unsigned int TileLevels::n_halved(const TileId tile) const
{
  if (!has_halves())
    return 0;
  const auto all = blocks(tile);
  return static_cast<unsigned int>(std::count_if(
    all.begin(), all.end(), [&](const TileId one) { return is_halved(one); }));
}


bool TileLevels::is_cell_halved(std::array<int, 3> cell) const
{
  for (unsigned int d = 0; d < 3; ++d)
  {
    const int end = n_cells(1, d);
    int &i = cell[d];
    while ((i < 0 && box_.reflects[2 * d]) ||
           (i >= end && box_.reflects[2 * d + 1]))
      i = i < 0 ? -1 - i : 2 * end - 1 - i;
    if (i < 0 || i >= end)
      return false;
  }
  return is_halved(tile_of(cell, 1));
}


bool TileLevels::are_halved(const std::array<int, 3> &first,
                            const std::array<int, 3> &last) const
{
  // One cell of each tile that the range overlaps.
  const auto next = [&](const int at, const unsigned int d) {
    return at == last[d] ? at + 1 : std::min(at + tile_edge, last[d]);
  };
  for (int z = first[2]; z <= last[2]; z = next(z, 2))
    for (int y = first[1]; y <= last[1]; y = next(y, 1))
      for (int x = first[0]; x <= last[0]; x = next(x, 0))
        if (!is_cell_halved({{x, y, z}}))
          return false;
  return true;
}


bool TileLevels::has_nodes(const std::array<int, 3> &node,
                           const unsigned int level) const
{
  if (level == 0 || is_halved(tile_of(node, 1)))
    return true;
  for (unsigned int d = 0; d < 3; ++d)
    if (node[d] >= n_cells(1, d))
      return true;
  return false;
}


bool TileLevels::is_active(const std::array<int, 3> &node,
                           const unsigned int degree) const
{
  // The support of a spline of odd degree extends (degree + 1) / 2 cells to
  // each side.
  const int support_half_width = static_cast<int>(degree + 1) / 2;
  std::array<int, 3> first = node, last = node;
  for (unsigned int d = 0; d < 3; ++d)
  {
    first[d] -= support_half_width;
    last[d] += support_half_width - 1;
  }
  return are_halved(first, last);
}
} // namespace contrecoup::mpm

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace contrecoup::mpm
{
/// Where the cells of a grid are halved, and for which splines.
struct Halving
{
  /// Whether the block of 2^3 cells with a lower corner and an edge [m] is
  /// halved; empty: none is. The same on all ranks.
  std::function<bool(const dealii::Point<3> &lower, const double edge)> blocks;
  unsigned int degree = 3; ///< of the splines, 1 or 3
};

/// A box of equal cubes, and which of its sides reflect or hold matter.
struct GridBox
{
  dealii::Point<3> lower; ///< corner [m]
  double cell_size = 1.;  ///< [m]
  std::array<unsigned int, 3> n_cells{{1, 1, 1}};
  /// Sides x-, x+, y-, y+, z-, z+. Beyond them lies the mirror image of the
  /// matter, so that it slides along them; particles must not cross others.
  std::array<bool, 6> reflects{};
  /// Of sides that reflect, those that hold what touches them: the image moves
  /// the other way in all directions, so that the velocity is zero there.
  std::array<bool, 6> is_no_slip{};
  Halving halving;
};

/**
 * The tiles of a grid and their levels: those of 4^3 cells of the box, level
 * 0, and in blocks of 2^3 cells that are halved those of 4^3 halved cells,
 * level 1. Ids of level 1 follow those of level 0; each level's lattice of
 * tiles covers the box.
 */
class TileLevels
{
public:
  using TileId = std::uint64_t;

  /// Cells of a tile along an edge.
  static constexpr int tile_edge = 4;
  /// Cells of level 0 of a tile of level 1 along an edge.
  static constexpr int block_edge = tile_edge / 2;

  /// Without halved blocks.
  void reinit(const GridBox &box);

  const GridBox &box() const
  {
    return box_;
  }

  /// Of level 0, along each direction.
  const std::array<unsigned int, 3> &n_tiles() const
  {
    return n_tiles_;
  }

  /// Blocks of a tile of level 0 that are to be halved, by box().halving.
  std::vector<TileId> blocks_to_halve(const TileId tile) const;

  /// Halves these blocks, on all ranks the same.
  void set_halved(const std::vector<TileId> &blocks);

  bool has_halves() const
  {
    return !is_halved_.empty();
  }
  unsigned int level(const TileId tile) const
  {
    return tile < n_coarse_ ? 0 : 1;
  }
  double cell_size(const unsigned int level) const
  {
    return std::ldexp(box_.cell_size, -static_cast<int>(level));
  }
  double smallest_cell_size() const
  {
    return cell_size(has_halves() ? 1 : 0);
  }
  int n_cells(const unsigned int level, const unsigned int direction) const
  {
    return static_cast<int>(box_.n_cells[direction] << level);
  }
  /// Along a direction, of all tiles; the nodes of the box are fewer.
  int n_nodes(const unsigned int level, const unsigned int direction) const
  {
    return static_cast<int>(tile_edge * n_tiles_[direction] << level);
  }

  /// Of a cell or node of a level inside of the lattice.
  TileId tile_of(const std::array<int, 3> &cell,
                 const unsigned int level) const;

  /// First cell of a tile, in cells of its level.
  std::array<int, 3> origin(const TileId tile) const;

  /// The tile of level 0 that a tile lies in.
  TileId coarse(const TileId tile) const;

  /// The tiles of level 1 in one of level 0, halved or not.
  std::array<TileId, 8> blocks(const TileId tile) const;

  /// Of a tile of level 1.
  bool is_halved(const TileId tile) const
  {
    return !is_halved_.empty() && is_halved_[tile - n_coarse_];
  }

  /// How many blocks of a tile of level 0 are halved.
  unsigned int n_halved(const TileId tile) const;

  /// Whether all cells of level 1 from first to last lie in halved blocks or
  /// their mirror images.
  bool are_halved(const std::array<int, 3> &first,
                  const std::array<int, 3> &last) const;

  /// Whether the tile that owns a node may have some in use.
  bool has_nodes(const std::array<int, 3> &node,
                 const unsigned int level) const;

  /// Whether splines of a node of level 1 vanish where cells are not halved.
  bool is_active(const std::array<int, 3> &node,
                 const unsigned int degree) const;

private:
  bool is_cell_halved(std::array<int, 3> cell) const;

  GridBox box_;
  std::array<unsigned int, 3> n_tiles_{};
  TileId n_coarse_ = 0;
  std::vector<bool> is_halved_; ///< by tile of level 1
};
} // namespace contrecoup::mpm

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
/// Local refinement of a grid by one level: which cells are halved, and for
/// which splines.
struct Halving
{
  /// Whether the block of 2^3 cells with the given lower corner and edge [m] is
  /// halved; the same on all ranks. Empty: no block is halved.
  std::function<bool(const dealii::Point<3> &lower, const double edge)> blocks;
  unsigned int degree = 3; ///< of the splines, 1 or 3
};

/// A box of equal cubic cells, with the boundary conditions of its sides.
struct GridBox
{
  dealii::Point<3> lower; ///< corner [m]
  double cell_size = 1.;  ///< [m]
  std::array<unsigned int, 3> n_cells{{1, 1, 1}};
  /// Sides x-, x+, y-, y+, z-, z+ with free slip: the grid beyond them is the
  /// mirror image of that inside. Particles must not cross other sides.
  std::array<bool, 6> reflects{};
  /// Reflecting sides without slip: the mirror image has the opposite velocity
  /// in all directions, so that the velocity is zero at the side.
  std::array<bool, 6> is_no_slip{};
  Halving halving;
};

/**
 * The tiles of a grid and their levels. A tile of level 0 consists of 4^3
 * cells; a tile of level 1 consists of the 4^3 halved cells of a block of 2^3
 * cells. Ids of level 1 follow those of level 0; the lattice of tiles of each
 * level covers the box.
 */
class TileLevels
{
public:
  using TileId = std::uint64_t;

  /// Number of cells of a tile along an edge.
  static constexpr int tile_edge = 4;
  /// Number of cells of level 0 along an edge of a tile of level 1.
  static constexpr int block_edge = tile_edge / 2;

  /// Sets the box, without halved blocks.
  void reinit(const GridBox &box);

  const GridBox &box() const
  {
    return box_;
  }

  /// Number of tiles of level 0 along each direction.
  const std::array<unsigned int, 3> &n_tiles() const
  {
    return n_tiles_;
  }

  /// Blocks of a tile of level 0 that box().halving asks to halve.
  std::vector<TileId> blocks_to_halve(const TileId tile) const;

  /// Marks these blocks as halved; must be the same on all ranks.
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
  /// Number of nodes of all tiles along a direction; the box has fewer.
  int n_nodes(const unsigned int level, const unsigned int direction) const
  {
    return static_cast<int>(tile_edge * n_tiles_[direction] << level);
  }

  /// The tile of a cell or node inside of the lattice of a level.
  TileId tile_of(const std::array<int, 3> &cell,
                 const unsigned int level) const;

  /// First cell of a tile, in cells of its level.
  std::array<int, 3> origin(const TileId tile) const;

  /// The tile of level 0 that contains a tile.
  TileId coarse(const TileId tile) const;

  /// The tiles of level 1 within a tile of level 0, whether halved or not.
  std::array<TileId, 8> blocks(const TileId tile) const;

  /// Whether a tile of level 1 is a halved block.
  bool is_halved(const TileId tile) const
  {
    return !is_halved_.empty() && is_halved_[tile - n_coarse_];
  }

  /// Number of halved blocks of a tile of level 0.
  unsigned int n_halved(const TileId tile) const;

  /// Whether all cells of level 1 from @p first to @p last lie in halved blocks
  /// or in their mirror images.
  bool are_halved(const std::array<int, 3> &first,
                  const std::array<int, 3> &last) const;

  /// Whether the tile that owns a node may have active nodes.
  bool has_nodes(const std::array<int, 3> &node,
                 const unsigned int level) const;

  /// Whether the spline of a node of level 1 vanishes outside of halved cells.
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

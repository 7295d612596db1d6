// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/tile_levels.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <unordered_map>
#include <vector>

namespace contrecoup::mpm
{
/**
 * The background grid: uniform, divided into tiles of 4^3 cells. The tiles are
 * the cells of a deal.II triangulation on p4est, which distributes them over
 * the ranks. Nodes exist only around tiles with particles. A tile owns the
 * nodes at the lower corners of its cells.
 *
 * Blocks of halved cells use truncated hierarchical B-splines: the active
 * splines are those of level 1 that vanish outside of halved cells, and the
 * splines of level 0 without their contributions from these. All of them are
 * positive and form a partition of unity, so that transfers are conservative.
 * Giannelli, Juettler and Speleers, Comput. Aided Geom. Des. 29 (2012). A step
 * that is stable on each level alone is stable on both: with lumped masses a
 * sum of splines has at least the inertia of its summands. The centre of a
 * truncated spline does not coincide with its node; for a linear field the
 * lumped velocity there is wrong by a quarter of its change over a cell with
 * cubic splines, by a tenth with two terms of the mass series.
 */
class TileGrid
{
public:
  /// Number of cells of a tile along an edge.
  static constexpr int tile_edge = TileLevels::tile_edge;
  static constexpr unsigned int nodes_per_tile = 64;

  /// Number of nodes along an edge of a tile's window, which contains the
  /// spline supports of the tile's particles. It begins at node window_start of
  /// the tile, and is padded to 8.
  static constexpr int window_edge = 8;
  static constexpr int window_start = -1;
  static constexpr unsigned int window_size = 512;

  /// Marks the absence of a node.
  static constexpr std::uint32_t no_node = -1;

  using TileId = TileLevels::TileId;

  /// A tile of this rank with particles.
  struct Source
  {
    TileId id;
    std::array<int, 3> origin; ///< first node of the tile in its level
    unsigned int level;
    /// Local index of each node of the window, or no_node. For a node behind a
    /// reflecting side it is that of its mirror image.
    std::vector<std::uint32_t> nodes;
    /// Bit d: the node is a mirror image along direction d; bit 3 + d: at a
    /// no-slip side. Empty without mirror images.
    std::vector<std::uint8_t> mirrored;
    /// For a tile of level 1 with nodes that depend on level 0: the window of
    /// level 0 at the same position (its first planes of nodes).
    std::shared_ptr<const Source> coarse;
    unsigned int
      degree; ///< of the splines that the two-scale relation combines
  };

  /**
   * @param weight relative work, from 0 to 1000, of the tile with a given lower
   * corner; the ranks get about equal sums. Collective.
   */
  void
  reinit(const GridBox &box,
         MPI_Comm communicator,
         const std::function<unsigned int(const dealii::Point<3> &)> &weight);

  /// Creates the nodes around the tiles of this rank that contain particles.
  /// @param sources their ids, each once. Collective.
  void activate(std::vector<TileId> sources);

  const GridBox &box() const
  {
    return levels_.box();
  }
  const TileLevels &levels() const
  {
    return levels_;
  }
  MPI_Comm communicator() const
  {
    return communicator_;
  }

  const std::vector<TileId> &own_tiles() const
  {
    return own_tiles_;
  }

  /// Cell of a level that contains a position, also outside of the box.
  std::array<int, 3> cell_at(const dealii::Point<3> &place,
                             const unsigned int level = 0) const;

  /// Whether a cell of level 0 is inside of the box.
  bool is_inside(const std::array<int, 3> &cell) const;

  /// The tile of level 0 that contains a cell inside of the box.
  TileId tile_of(const std::array<int, 3> &cell) const
  {
    return levels_.tile_of(cell, 0);
  }

  /// The tile to which particles at a position inside of the box belong.
  TileId tile_at(const dealii::Point<3> &place) const;

  /// Level of the cells at a position inside of the box.
  unsigned int level_at(const dealii::Point<3> &place) const
  {
    return levels_.has_halves() ? levels_.level(tile_at(place)) : 0;
  }

  /// First cell of a tile in its level.
  std::array<int, 3> origin(const TileId tile) const
  {
    return levels_.origin(tile);
  }

  /// The rank of an owned or neighbouring tile. @throws NumericsError for
  /// others
  unsigned int owner(const TileId tile) const;

  /// The tiles with particles, sorted by id.
  const std::vector<Source> &sources() const
  {
    return sources_;
  }

  /// The same tiles with the windows of linear splines.
  const std::vector<Source> &linear_sources() const
  {
    return linear_sources_.empty() ? sources_ : linear_sources_;
  }

  std::size_t n_locally_owned_nodes() const
  {
    return partitioner_->locally_owned_size();
  }
  std::size_t n_nodes() const
  {
    return n_locally_owned_nodes() + partitioner_->n_ghost_indices();
  }

  /// Partitioner of the nodes over the ranks.
  const dealii::Utilities::MPI::Partitioner &partitioner() const
  {
    return *partitioner_;
  }

  /// Local nodes whose velocity is zero at reflecting sides, by direction:
  /// along the normal or, at no-slip sides, along each direction.
  const std::array<std::vector<std::uint32_t>, 3> &plane_nodes() const
  {
    return plane_nodes_;
  }

  /// Position of an owned or ghost node [m].
  dealii::Point<3> place(const std::uint32_t node) const;

private:
  void find_tiles(
    const std::function<unsigned int(const dealii::Point<3> &)> &weight);
  /// Finds the blocks to be halved. @param tiles of level 0
  void halve_blocks(const dealii::Triangulation<3> &tiles);
  /// Adds a tile of level 0, and the tiles of level 1 in it, to the tiles of
  /// this rank.
  void add_own(const TileId tile);
  /// The tile of level 0 with a lower corner.
  TileId tile_at_corner(const dealii::Point<3> &corner) const;
  /// Replaces a node behind a reflecting side by its mirror image. @return
  /// false if no node exists there
  bool reflect(const unsigned int level,
               std::array<int, 3> &node,
               std::uint8_t &mirrored) const;
  /// Adds the tiles that own nodes of the window of a tile.
  void add_touched(const std::array<int, 3> &origin,
                   const unsigned int level,
                   std::set<TileId> &touched) const;
  /// Whether spline supports of a tile of level 1 contain cells that are not
  /// halved.
  bool is_at_border(const TileId tile) const;
  /// Numbers the tiles with nodes. @param needed tiles that this rank needs, of
  /// any owner
  void number_tiles(const std::vector<TileId> &needed);
  Source make_source(const TileId tile, const unsigned int degree) const;
  void make_window(Source &source) const;
  void find_plane_nodes();

  TileLevels levels_;
  MPI_Comm communicator_ = MPI_COMM_SELF;
  std::vector<TileId> own_tiles_;
  std::unordered_map<TileId, unsigned int> owners_; ///< of tiles of level 0
  std::vector<Source> sources_, linear_sources_;
  /// Local numbers of tiles with nodes, owned ones first.
  std::unordered_map<TileId, std::uint32_t> local_tile_;
  std::vector<TileId> tiles_with_nodes_; ///< by local number
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner_;
  std::array<std::vector<std::uint32_t>, 3> plane_nodes_;
};
} // namespace contrecoup::mpm

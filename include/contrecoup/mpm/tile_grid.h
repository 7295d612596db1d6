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
 * The background grid: a uniform grid of nodes, cut into tiles of 4^3 cells.
 * The tiles are the cells of a deal.II triangulation on p4est, which gives each
 * to a rank. Nodes exist around tiles with particles alone. A tile owns the
 * nodes at the lower corners of its cells.
 *
 * Where blocks of cells are halved, their nodes are those of truncated
 * hierarchical B-splines: halved cells have the splines of level 1 that vanish
 * in all others, and the sums of those left that make the splines of level 0.
 * All together are positive and sum up to 1, so that what particles give to the
 * grid is kept. Giannelli, Juettler and Speleers, Comput. Aided Geom. Des. 29
 * (2012). Steps that are stable in the cells of each level by themselves are
 * so: a lumped mass gives a sum of splines no less inertia than its parts have.
 * What is left of cut splines has its centre beside the node, so that lumped
 * velocities of linear fields err there, by a quarter of what they change over
 * a cell with cubic splines, by a tenth with two terms of the mass series.
 */
class TileGrid
{
public:
  /// Cells of a tile along an edge.
  static constexpr int tile_edge = TileLevels::tile_edge;
  static constexpr unsigned int nodes_per_tile = 64;

  /// Nodes along an edge of the window of a tile: those that splines of its
  /// particles reach, from node window_start of the tile on, padded to 8.
  static constexpr int window_edge = 8;
  static constexpr int window_start = -1;
  static constexpr unsigned int window_size = 512;

  /// No node is there.
  static constexpr std::uint32_t no_node = -1;

  using TileId = TileLevels::TileId;

  /// A tile with particles of this rank.
  struct Source
  {
    TileId id;
    std::array<int, 3> origin; ///< first node of the tile in its level
    unsigned int level;
    /// Local node of each node of the window, or no_node; of those behind a
    /// side that reflects, the mirror image.
    std::vector<std::uint32_t> nodes;
    /// Bit d: the node is a mirror image along direction d; bit 3 + d: that of
    /// a side that holds matter; empty: none is.
    std::vector<std::uint8_t> mirrored;
    /// Of a tile of level 1 whose other nodes are sums of those of level 0:
    /// the window of level 0 at the same place, its first planes of nodes.
    std::shared_ptr<const Source> coarse;
    unsigned int degree; ///< of the splines that are summed
  };

  /**
   * @param weight of the tile whose lower corner is given: the work that it
   *   makes, from 0 to 1000; ranks get about equal sums
   * Collective.
   */
  void
  reinit(const GridBox &box,
         MPI_Comm communicator,
         const std::function<unsigned int(const dealii::Point<3> &)> &weight);

  /// Makes the nodes around tiles of this rank that have particles, given by
  /// their ids without repetition. Collective.
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

  /// Cell of a level at a place, which may be outside of the box.
  std::array<int, 3> cell_at(const dealii::Point<3> &place,
                             const unsigned int level = 0) const;

  /// Of a cell of level 0.
  bool is_inside(const std::array<int, 3> &cell) const;

  /// The tile of level 0 of a cell inside of the box.
  TileId tile_of(const std::array<int, 3> &cell) const
  {
    return levels_.tile_of(cell, 0);
  }

  /// The tile whose particles are those at a place inside of the box.
  TileId tile_at(const dealii::Point<3> &place) const;

  /// Of the cells at a place inside of the box.
  unsigned int level_at(const dealii::Point<3> &place) const
  {
    return levels_.has_halves() ? levels_.level(tile_at(place)) : 0;
  }

  /// First cell of a tile in its level.
  std::array<int, 3> origin(const TileId tile) const
  {
    return levels_.origin(tile);
  }

  /// The rank of an own or neighbouring tile. @throws NumericsError for others
  unsigned int owner(const TileId tile) const;

  /// In the order of the sorted ids.
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

  /// Of the nodes that tiles share between ranks.
  const dealii::Utilities::MPI::Partitioner &partitioner() const
  {
    return *partitioner_;
  }

  /// Local nodes that planes which reflect keep from moving, by direction:
  /// that of the normal, or each where a plane holds matter.
  const std::array<std::vector<std::uint32_t>, 3> &plane_nodes() const
  {
    return plane_nodes_;
  }

  /// Place of an own node or a copy [m].
  dealii::Point<3> place(const std::uint32_t node) const;

private:
  void find_tiles(
    const std::function<unsigned int(const dealii::Point<3> &)> &weight);
  /// Finds the blocks that are halved. @param tiles of level 0
  void halve_blocks(const dealii::Triangulation<3> &tiles);
  /// Takes a tile of level 0 of this rank and those in it.
  void add_own(const TileId tile);
  /// The tile of level 0 with a lower corner.
  TileId tile_at_corner(const dealii::Point<3> &corner) const;
  /// The node in the box for one that may lie behind a side that reflects.
  /// @return false where there is none
  bool reflect(const unsigned int level,
               std::array<int, 3> &node,
               std::uint8_t &mirrored) const;
  /// Tiles that own nodes of a range beside the first node of a tile.
  void add_touched(const std::array<int, 3> &origin,
                   const unsigned int level,
                   std::set<TileId> &touched) const;
  /// Whether splines of a tile of level 1 reach into cells that are not halved.
  bool is_at_border(const TileId tile) const;
  /// Numbers the tiles with nodes. @param needed by this rank, any owner
  void number_tiles(const std::vector<TileId> &needed);
  Source make_source(const TileId tile, const unsigned int degree) const;
  void make_window(Source &source) const;
  void find_plane_nodes();

  TileLevels levels_;
  MPI_Comm communicator_ = MPI_COMM_SELF;
  std::vector<TileId> own_tiles_;
  std::unordered_map<TileId, unsigned int> owners_; ///< of tiles of level 0
  std::vector<Source> sources_, linear_sources_;
  /// Local number of tiles with nodes, own ones first.
  std::unordered_map<TileId, std::uint32_t> local_tile_;
  std::vector<TileId> tiles_with_nodes_; ///< by local number
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner_;
  std::array<std::vector<std::uint32_t>, 3> plane_nodes_;
};
} // namespace contrecoup::mpm

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/partitioner.h>
#include <deal.II/base/point.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

namespace contrecoup::mpm
{
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
  std::array<bool, 6> holds{};
};

/**
 * The background grid: a uniform grid of nodes, cut into tiles of 4^3 cells.
 * The tiles are the cells of a deal.II triangulation on p4est, which gives each
 * to a rank. Nodes exist around tiles with particles alone. A tile owns the
 * nodes at the lower corners of its cells.
 */
class TileGrid
{
public:
  /// Cells of a tile along an edge.
  static constexpr int tile_edge = 4;
  static constexpr unsigned int nodes_per_tile = 64;

  /// Nodes along an edge of the window of a tile: those that splines of its
  /// particles reach, from node window_start of the tile on, padded to 8.
  static constexpr int window_edge = 8;
  static constexpr int window_start = -1;
  static constexpr unsigned int window_size = 512;

  /// No node is there.
  static constexpr std::uint32_t no_node = -1;

  using TileId = std::uint64_t;

  /// A tile with particles of this rank.
  struct Source
  {
    TileId id;
    std::array<int, 3> origin; ///< first node of the tile in the grid
    /// Local node of each node of the window, or no_node; of those behind a
    /// side that reflects, the mirror image.
    std::vector<std::uint32_t> nodes;
    /// Bit d: the node is a mirror image along direction d; bit 3 + d: that of
    /// a side that holds matter; empty: none is.
    std::vector<std::uint8_t> mirrored;
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
    return box_;
  }
  MPI_Comm communicator() const
  {
    return communicator_;
  }

  const std::vector<TileId> &own_tiles() const
  {
    return own_tiles_;
  }

  /// Cell of the grid at a place, which may be outside of the box.
  std::array<int, 3> cell_at(const dealii::Point<3> &place) const;

  bool is_inside(const std::array<int, 3> &cell) const;

  /// Of a cell inside of the box.
  TileId tile_of(const std::array<int, 3> &cell) const;

  /// First cell of a tile.
  std::array<int, 3> origin(const TileId tile) const;

  /// The rank of an own or neighbouring tile. @throws NumericsError for others
  unsigned int owner(const TileId tile) const;

  /// In the order of the sorted ids.
  const std::vector<Source> &sources() const
  {
    return sources_;
  }

  std::size_t n_own_nodes() const
  {
    return partitioner_->locally_owned_size();
  }
  std::size_t n_nodes() const
  {
    return n_own_nodes() + partitioner_->n_ghost_indices();
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
  /// The node in the box for one that may lie behind a side that reflects.
  /// @return false where there is none
  bool reflect(std::array<int, 3> &node, std::uint8_t &mirrored) const;
  /// Ids of tiles that own nodes of the window of a tile.
  std::vector<TileId> touched_tiles(const TileId tile) const;
  /// Numbers the tiles with nodes. @param needed by this rank, any owner
  void number_tiles(const std::vector<TileId> &needed);
  void make_window(Source &source) const;
  void find_plane_nodes();

  GridBox box_;
  MPI_Comm communicator_ = MPI_COMM_SELF;
  std::array<unsigned int, 3> n_tiles_{};
  std::vector<TileId> own_tiles_;
  std::unordered_map<TileId, unsigned int> owners_;
  std::vector<Source> sources_;
  /// Local number of tiles with nodes, own ones first.
  std::unordered_map<TileId, std::uint32_t> local_tile_;
  std::vector<TileId> tiles_with_nodes_; ///< by local number
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner_;
  std::array<std::vector<std::uint32_t>, 3> plane_nodes_;
};
} // namespace contrecoup::mpm

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

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
};

/**
 * The background grid: uniform, divided into tiles of 4^3 cells. The tiles are
 * the cells of a deal.II triangulation on p4est, which distributes them over
 * the ranks. Nodes exist only around tiles with particles. A tile owns the
 * nodes at the lower corners of its cells.
 */
class TileGrid
{
public:
  /// Number of cells of a tile along an edge.
  static constexpr int tile_edge = 4;
  static constexpr unsigned int nodes_per_tile = 64;

  /// Number of nodes along an edge of a tile's window, which contains the
  /// spline supports of the tile's particles. It begins at node window_start of
  /// the tile, and is padded to 8.
  static constexpr int window_edge = 8;
  static constexpr int window_start = -1;
  static constexpr unsigned int window_size = 512;

  /// Marks the absence of a node.
  static constexpr std::uint32_t no_node = -1;

  using TileId = std::uint64_t;

  /// A tile of this rank with particles.
  struct Source
  {
    TileId id;
    std::array<int, 3> origin; ///< first node of the tile
    /// Local index of each node of the window, or no_node. For a node behind a
    /// reflecting side it is that of its mirror image.
    std::vector<std::uint32_t> nodes;
    /// Bit d: the node is a mirror image along direction d; bit 3 + d: at a
    /// no-slip side. Empty without mirror images.
    std::vector<std::uint8_t> mirrored;
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

  /// Cell that contains a position, also outside of the box.
  std::array<int, 3> cell_at(const dealii::Point<3> &place) const;

  /// Whether a cell is inside of the box.
  bool is_inside(const std::array<int, 3> &cell) const;

  /// The tile that contains a cell or owns a node.
  TileId tile_of(const std::array<int, 3> &cell) const;

  /// The tile to which particles at a position inside of the box belong.
  TileId tile_at(const dealii::Point<3> &place) const
  {
    return tile_of(cell_at(place));
  }

  /// First cell of a tile.
  std::array<int, 3> origin(const TileId tile) const;

  /// The rank of an owned or neighbouring tile. @throws NumericsError for
  /// others
  unsigned int owner(const TileId tile) const;

  /// The tiles with particles, sorted by id.
  const std::vector<Source> &sources() const
  {
    return sources_;
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
  /// The tile with a lower corner.
  TileId tile_at_corner(const dealii::Point<3> &corner) const;
  /// Replaces a node behind a reflecting side by its mirror image. @return
  /// false if no node exists there
  bool reflect(std::array<int, 3> &node, std::uint8_t &mirrored) const;
  /// Adds the tiles that own nodes of the window of a tile.
  void add_touched(const TileId tile, std::set<TileId> &touched) const;
  /// Numbers the tiles with nodes. @param needed tiles that this rank needs, of
  /// any owner
  void number_tiles(const std::vector<TileId> &needed);
  Source make_source(const TileId tile) const;
  void find_plane_nodes();

  GridBox box_;
  std::array<unsigned int, 3> n_tiles_{}; ///< along each direction
  MPI_Comm communicator_ = MPI_COMM_SELF;
  std::vector<TileId> own_tiles_;
  std::unordered_map<TileId, unsigned int> owners_;
  std::vector<Source> sources_;
  /// Local numbers of tiles with nodes, owned ones first.
  std::unordered_map<TileId, std::uint32_t> local_tile_;
  std::vector<TileId> tiles_with_nodes_; ///< by local number
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner_;
  std::array<std::vector<std::uint32_t>, 3> plane_nodes_;
};
} // namespace contrecoup::mpm

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/mpm/tile_grid.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace contrecoup::mpm
{
namespace
{
  using TileId = TileGrid::TileId;

  /// Last node, counted from the tile's first one, in the spline supports of
  /// its particles.
  constexpr int last_node = TileGrid::tile_edge + 1;

  unsigned int node_in_tile(const std::array<int, 3> &node)
  {
    constexpr int edge = TileGrid::tile_edge;
    return static_cast<unsigned int>(
      (node[0] % edge) + edge * ((node[1] % edge) + edge * (node[2] % edge)));
  }
} // namespace


void TileGrid::reinit(
  const GridBox &box,
  const MPI_Comm communicator,
  const std::function<unsigned int(const dealii::Point<3> &)> &weight)
{
  box_ = box;
  // Nodes at upper sides belong to tiles as well.
  for (unsigned int d = 0; d < 3; ++d)
    n_tiles_[d] = box.n_cells[d] / tile_edge + 1;
  communicator_ = communicator;
  find_tiles(weight);
  activate({});
}


TileGrid::TileId TileGrid::tile_at_corner(const dealii::Point<3> &corner) const
{
  const double edge = tile_edge * box().cell_size;
  std::array<int, 3> cell;
  for (unsigned int d = 0; d < 3; ++d)
    cell[d] = tile_edge * static_cast<int>(
                            std::lround((corner[d] - box().lower[d]) / edge));
  return tile_of(cell);
}


TileGrid::TileId TileGrid::tile_of(const std::array<int, 3> &cell) const
{
  TileId id = 0;
  for (int d = 2; d >= 0; --d)
    id = id * n_tiles_[d] + static_cast<unsigned int>(cell[d] / tile_edge);
  return id;
}


std::array<int, 3> TileGrid::origin(const TileId tile) const
{
  const TileId rest = tile / n_tiles_[0];
  return {{tile_edge * static_cast<int>(tile % n_tiles_[0]),
           tile_edge * static_cast<int>(rest % n_tiles_[1]),
           tile_edge * static_cast<int>(rest / n_tiles_[1])}};
}


void TileGrid::find_tiles(
  const std::function<unsigned int(const dealii::Point<3> &)> &weight)
{
  const auto &n = n_tiles_;
  dealii::Point<3> upper = box().lower;
  for (unsigned int d = 0; d < 3; ++d)
    upper[d] += tile_edge * box().cell_size * n[d];
  dealii::parallel::distributed::Triangulation<3> tiles(communicator_);
  dealii::GridGenerator::subdivided_hyper_rectangle(
    tiles, {n[0], n[1], n[2]}, box().lower, upper);
  if (weight)
  {
    tiles.signals.weight.connect([&](const auto &cell, const auto) {
      // More than the weight that deal.II gives to each cell.
      return 8 * weight(cell->vertex(0));
    });
    tiles.repartition();
  }
  own_tiles_.clear();
  owners_.clear();
  for (const auto &cell : tiles.active_cell_iterators())
    if (!cell->is_artificial())
    {
      const TileId id = tile_at_corner(cell->vertex(0));
      owners_[id] = cell->subdomain_id();
      if (cell->is_locally_owned())
        own_tiles_.push_back(id);
    }
  std::sort(own_tiles_.begin(), own_tiles_.end());
}


std::array<int, 3> TileGrid::cell_at(const dealii::Point<3> &place) const
{
  std::array<int, 3> cell;
  for (unsigned int d = 0; d < 3; ++d)
    cell[d] = static_cast<int>(
      std::floor((place[d] - box().lower[d]) / box_.cell_size));
  return cell;
}


bool TileGrid::is_inside(const std::array<int, 3> &cell) const
{
  for (unsigned int d = 0; d < 3; ++d)
    if (cell[d] < 0 || cell[d] >= static_cast<int>(box_.n_cells[d]))
      return false;
  return true;
}


unsigned int TileGrid::owner(const TileId tile) const
{
  const auto found = owners_.find(tile);
  if (found == owners_.end())
    throw NumericsError("a particle went beyond the neighbouring tiles in one "
                        "step; take a smaller Courant number");
  return found->second;
}


bool TileGrid::reflect(std::array<int, 3> &node, std::uint8_t &mirrored) const
{
  mirrored = 0;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const int last = box_.n_cells[d];
    int &i = node[d];
    const unsigned int side = i < 0 ? 2 * d : 2 * d + 1;
    if ((i < 0 || i > last) && box().reflects[side])
    {
      i = i < 0 ? -i : 2 * last - i;
      mirrored |= (box().is_no_slip[side] ? 9u : 1u) << d;
    }
    if (i < 0 || i >= static_cast<int>(tile_edge * n_tiles_[d]))
      return false;
  }
  return true;
}


void TileGrid::add_touched(const TileId tile, std::set<TileId> &touched) const
{
  const auto first = origin(tile);
  // One node of each tile that the window may overlap.
  const std::array<int, 4> steps{{window_start, 0, tile_edge, last_node}};
  std::array<int, 3> node;
  std::uint8_t mirrored;
  for (const int z : steps)
    for (const int y : steps)
      for (const int x : steps)
      {
        node = {{first[0] + x, first[1] + y, first[2] + z}};
        if (reflect(node, mirrored))
          touched.insert(tile_of(node));
      }
}


void TileGrid::number_tiles(const std::vector<TileId> &needed)
{
  using Lists = std::map<unsigned int, std::vector<TileId>>;
  const unsigned int me =
    dealii::Utilities::MPI::this_mpi_process(communicator_);
  std::set<TileId> own;
  Lists wanted;
  for (const TileId tile : needed)
  {
    const unsigned int rank = owner(tile);
    if (rank == me)
      own.insert(tile);
    else
      wanted[rank].push_back(tile);
  }
  const Lists asked =
    dealii::Utilities::MPI::some_to_some(communicator_, wanted);
  for (const auto &from : asked)
    own.insert(from.second.begin(), from.second.end());

  tiles_with_nodes_.assign(own.begin(), own.end());
  local_tile_.clear();
  for (std::size_t i = 0; i < tiles_with_nodes_.size(); ++i)
    local_tile_[tiles_with_nodes_[i]] = i;
  const auto counts =
    dealii::Utilities::MPI::all_gather(communicator_, own.size());
  TileId begin = 0, total = 0;
  for (unsigned int rank = 0; rank < counts.size(); ++rank)
  {
    begin += rank < me ? counts[rank] : 0;
    total += counts[rank];
  }
  Lists answers;
  for (const auto &from : asked)
    for (const TileId tile : from.second)
      answers[from.first].push_back(begin + local_tile_.at(tile));
  const Lists numbers =
    dealii::Utilities::MPI::some_to_some(communicator_, answers);

  std::map<TileId, TileId> ghosts; // by their numbers, so that they are sorted
  for (const auto &from : numbers)
    for (std::size_t i = 0; i < from.second.size(); ++i)
      ghosts[from.second[i]] = wanted.at(from.first)[i];
  dealii::IndexSet own_nodes(nodes_per_tile * total),
    ghost_nodes(nodes_per_tile * total);
  own_nodes.add_range(nodes_per_tile * begin,
                      nodes_per_tile * (begin + own.size()));
  for (const auto &ghost : ghosts)
  {
    ghost_nodes.add_range(nodes_per_tile * ghost.first,
                          nodes_per_tile * (ghost.first + 1));
    local_tile_[ghost.second] = tiles_with_nodes_.size();
    tiles_with_nodes_.push_back(ghost.second);
  }
  // deal.II cannot distribute an empty range over several ranks.
  partitioner_ = total == 0
                   ? std::make_shared<dealii::Utilities::MPI::Partitioner>()
                   : std::make_shared<dealii::Utilities::MPI::Partitioner>(
                       own_nodes, ghost_nodes, communicator_);
}


TileGrid::Source TileGrid::make_source(const TileId tile) const
{
  Source source{tile, origin(tile), {}, {}};
  source.nodes.assign(window_size, no_node);
  std::vector<std::uint8_t> mirrored(window_size, 0);
  bool any = false;
  for (int z = window_start; z <= last_node; ++z)
    for (int y = window_start; y <= last_node; ++y)
      for (int x = window_start; x <= last_node; ++x)
      {
        const unsigned int at =
          (x - window_start) +
          window_edge * ((y - window_start) + window_edge * (z - window_start));
        std::array<int, 3> node{
          {source.origin[0] + x, source.origin[1] + y, source.origin[2] + z}};
        if (!reflect(node, mirrored[at]))
          continue;
        const auto owner = local_tile_.find(tile_of(node));
        if (owner == local_tile_.end())
          continue;
        source.nodes[at] = nodes_per_tile * owner->second + node_in_tile(node);
        any = any || mirrored[at] != 0;
      }
  if (any)
    source.mirrored = std::move(mirrored);
  return source;
}


dealii::Point<3> TileGrid::place(const std::uint32_t node) const
{
  const TileId tile = tiles_with_nodes_[node / nodes_per_tile];
  const auto first = origin(tile);
  const unsigned int inside = node % nodes_per_tile;
  const unsigned int offset[] = {inside % tile_edge,
                                 inside / tile_edge % tile_edge,
                                 inside / (tile_edge * tile_edge)};
  dealii::Point<3> result = box().lower;
  for (unsigned int d = 0; d < 3; ++d)
    result[d] += box_.cell_size * (first[d] + static_cast<int>(offset[d]));
  return result;
}


void TileGrid::find_plane_nodes()
{
  for (auto &nodes : plane_nodes_)
    nodes.clear();
  for (std::uint32_t node = 0; node < n_nodes(); ++node)
  {
    const auto distance = place(node) - box().lower;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const long int i = std::lround(distance[d] / box_.cell_size);
      const unsigned int side = i == 0 ? 2 * d : 2 * d + 1;
      if ((i == 0 || i == box_.n_cells[d]) && box().reflects[side])
        for (unsigned int e = 0; e < 3; ++e)
          if (e == d || box().is_no_slip[side])
            plane_nodes_[e].push_back(node);
    }
  }
}


void TileGrid::activate(std::vector<TileId> sources)
{
  std::sort(sources.begin(), sources.end());
  std::set<TileId> needed;
  for (const TileId tile : sources)
    add_touched(tile, needed);
  number_tiles({needed.begin(), needed.end()});
  sources_.clear();
  for (const TileId tile : sources)
    sources_.push_back(make_source(tile));
  find_plane_nodes();
}
} // namespace contrecoup::mpm

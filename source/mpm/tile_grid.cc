// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/mpm/tile_grid.h>
#include <contrecoup/mpm/two_scale.h>

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
  levels_.reinit(box);
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


void TileGrid::halve_blocks(const dealii::Triangulation<3> &tiles)
{
  if (!box().halving.blocks)
    return;
  std::vector<TileId> own, all;
  for (const auto &cell : tiles.active_cell_iterators())
    if (cell->is_locally_owned())
      for (const TileId block :
           levels_.blocks_to_halve(tile_at_corner(cell->vertex(0))))
        own.push_back(block);
  for (const auto &from :
       dealii::Utilities::MPI::all_gather(communicator_, own))
    all.insert(all.end(), from.begin(), from.end());
  levels_.set_halved(all);
}


void TileGrid::find_tiles(
  const std::function<unsigned int(const dealii::Point<3> &)> &weight)
{
  const auto &n = levels_.n_tiles();
  dealii::Point<3> upper = box().lower;
  for (unsigned int d = 0; d < 3; ++d)
    upper[d] += tile_edge * box().cell_size * n[d];
  dealii::parallel::distributed::Triangulation<3> tiles(communicator_);
  dealii::GridGenerator::subdivided_hyper_rectangle(
    tiles, {n[0], n[1], n[2]}, box().lower, upper);
  halve_blocks(tiles);
  if (weight)
  {
    tiles.signals.weight.connect([&](const auto &cell, const auto) {
      // A halved block needs as much work as the eight blocks of a tile.
      const unsigned int halved =
        levels_.n_halved(tile_at_corner(cell->vertex(0)));
      return weight(cell->vertex(0)) * (8 + 7 * halved);
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
        add_own(id);
    }
  std::sort(own_tiles_.begin(), own_tiles_.end());
}


void TileGrid::add_own(const TileId tile)
{
  if (levels_.n_halved(tile) < 8)
    own_tiles_.push_back(tile);
  if (levels_.has_halves())
    for (const TileId block : levels_.blocks(tile))
      if (levels_.is_halved(block))
        own_tiles_.push_back(block);
}


std::array<int, 3> TileGrid::cell_at(const dealii::Point<3> &place,
                                     const unsigned int level) const
{
  std::array<int, 3> cell;
  for (unsigned int d = 0; d < 3; ++d)
    cell[d] = static_cast<int>(
      std::floor((place[d] - box().lower[d]) / levels_.cell_size(level)));
  return cell;
}


bool TileGrid::is_inside(const std::array<int, 3> &cell) const
{
  for (unsigned int d = 0; d < 3; ++d)
    if (cell[d] < 0 || cell[d] >= levels_.n_cells(0, d))
      return false;
  return true;
}


TileGrid::TileId TileGrid::tile_at(const dealii::Point<3> &place) const
{
  if (levels_.has_halves())
    if (const TileId block = levels_.tile_of(cell_at(place, 1), 1);
        levels_.is_halved(block))
      return block;
  return tile_of(cell_at(place));
}


unsigned int TileGrid::owner(const TileId tile) const
{
  const auto found = owners_.find(levels_.coarse(tile));
  if (found == owners_.end())
    throw NumericsError("a particle went beyond the neighbouring tiles in one "
                        "step; take a smaller Courant number");
  return found->second;
}


bool TileGrid::reflect(const unsigned int level,
                       std::array<int, 3> &node,
                       std::uint8_t &mirrored) const
{
  mirrored = 0;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const int last = levels_.n_cells(level, d);
    int &i = node[d];
    const unsigned int side = i < 0 ? 2 * d : 2 * d + 1;
    if ((i < 0 || i > last) && box().reflects[side])
    {
      i = i < 0 ? -i : 2 * last - i;
      mirrored |= (box().is_no_slip[side] ? 9u : 1u) << d;
    }
    if (i < 0 || i >= levels_.n_nodes(level, d))
      return false;
  }
  return true;
}


void TileGrid::add_touched(const std::array<int, 3> &origin,
                           const unsigned int level,
                           std::set<TileId> &touched) const
{
  // One node of each tile that the window may overlap.
  const std::array<int, 4> steps{{window_start, 0, tile_edge, last_node}};
  std::array<int, 3> node;
  std::uint8_t mirrored;
  for (const int z : steps)
    for (const int y : steps)
      for (const int x : steps)
      {
        node = {{origin[0] + x, origin[1] + y, origin[2] + z}};
        if (reflect(level, node, mirrored) && levels_.has_nodes(node, level))
          touched.insert(levels_.tile_of(node, level));
      }
}


bool TileGrid::is_at_border(const TileId tile) const
{
  std::array<int, 3> first = origin(tile), last = first;
  for (unsigned int d = 0; d < 3; ++d)
  {
    first[d] -= 3;
    last[d] += 6;
  }
  return !levels_.are_halved(first, last);
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


void TileGrid::make_window(Source &source) const
{
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
        if (source.level == 1 && !levels_.is_active(node, source.degree))
          continue;
        if (!reflect(source.level, node, mirrored[at]))
          continue;
        const auto tile = local_tile_.find(levels_.tile_of(node, source.level));
        if (tile == local_tile_.end())
          continue;
        source.nodes[at] = nodes_per_tile * tile->second + node_in_tile(node);
        any = any || mirrored[at] != 0;
      }
  source.mirrored.clear();
  if (any)
    source.mirrored = std::move(mirrored);
}


TileGrid::Source TileGrid::make_source(const TileId tile,
                                       const unsigned int degree) const
{
  Source source{tile, origin(tile), levels_.level(tile), {}, {}, {}, degree};
  make_window(source);
  if (source.level == 1 && is_at_border(tile))
  {
    Source coarse = source;
    coarse.level = 0;
    for (int &i : coarse.origin)
      i /= 2;
    make_window(coarse);
    coarse.nodes.resize(two_scale_nodes * window_edge * window_edge);
    source.coarse = std::make_shared<const Source>(std::move(coarse));
  }
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
    result[d] += levels_.cell_size(levels_.level(tile)) *
                 (first[d] + static_cast<int>(offset[d]));
  return result;
}


void TileGrid::find_plane_nodes()
{
  for (auto &nodes : plane_nodes_)
    nodes.clear();
  for (std::uint32_t node = 0; node < n_nodes(); ++node)
  {
    const unsigned int level =
      levels_.level(tiles_with_nodes_[node / nodes_per_tile]);
    const auto distance = place(node) - box().lower;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const long int i = std::lround(distance[d] / levels_.cell_size(level));
      const unsigned int side = i == 0 ? 2 * d : 2 * d + 1;
      if ((i == 0 || i == levels_.n_cells(level, d)) && box().reflects[side])
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
  {
    auto first = origin(tile);
    const unsigned int level = levels_.level(tile);
    add_touched(first, level, needed);
    if (level == 0 || !is_at_border(tile))
      continue;
    for (int &i : first)
      i /= 2;
    add_touched(first, 0, needed);
  }
  number_tiles({needed.begin(), needed.end()});
  sources_.clear();
  linear_sources_.clear();
  const unsigned int degree = box().halving.degree;
  for (const TileId tile : sources)
    sources_.push_back(make_source(tile, degree));
  if (levels_.has_halves() && degree > 1)
    for (const TileId tile : sources)
      linear_sources_.push_back(make_source(tile, 1));
  find_plane_nodes();
}
} // namespace contrecoup::mpm

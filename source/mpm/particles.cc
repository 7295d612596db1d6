// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/mpm/particle_motion.h>
#include <contrecoup/mpm/particles.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <string>

namespace contrecoup::mpm
{
/// A particle that moves to another tile.
struct Particles::LeavingParticle
{
  TileGrid::TileId tile;
  unsigned int material;
  std::array<double, column::n_state_columns> state;

  template <class Archive>
  void serialize(Archive &archive, const unsigned int)
  {
    archive &tile &material &state;
  }
};


namespace
{
  /// Throws on all ranks if @p problem is not empty on one of them. Collective.
  void require_none(const std::string &problem, const MPI_Comm communicator)
  {
    namespace mpi = dealii::Utilities::MPI;
    if (mpi::max(problem.empty() ? 0 : 1, communicator) == 0)
      return;
    const auto all = mpi::all_gather(communicator, problem);
    throw NumericsError(*std::find_if(
      all.begin(), all.end(), [](auto &one) { return !one.empty(); }));
  }
} // namespace


ParticleBlock &Particles::block(const TileGrid::TileId tile,
                                const unsigned int material)
{
  TileBlocks &blocks = tiles_[tile];
  if (blocks.empty())
    blocks.resize(n_materials_);
  return blocks[material];
}


std::size_t Particles::size() const
{
  std::size_t sum = 0;
  for_each_block(
    [&](unsigned int, const ParticleBlock &one) { sum += one.size(); });
  return sum;
}


void Particles::remove_leaving(const TileGrid &grid,
                               const TileGrid::TileId tile,
                               const unsigned int material,
                               std::vector<LeavingParticle> &leaving)
{
  ParticleBlock &particles = tiles_[tile][material];
  const std::array<int, 3> first = grid.origin(tile);
  std::array<int, 3> end;
  for (unsigned int d = 0; d < 3; ++d)
    end[d] = std::min(first[d] + TileGrid::tile_edge,
                      static_cast<int>(grid.box().n_cells[d]));
  if (are_inside(particles,
                 &grid.box().lower[0],
                 grid.box().cell_size,
                 first.data(),
                 end.data()))
    return;
  for (std::size_t p = particles.size(); p-- > 0;)
  {
    dealii::Point<3> place;
    for (unsigned int d = 0; d < 3; ++d)
      place[d] = particles[column::position + d][p];
    if (!grid.is_inside(grid.cell_at(place)))
      throw NumericsError("a particle left the grid at (" + coordinates(place) +
                          ") m; make the grid larger");
    const auto there = grid.tile_at(place);
    if (there == tile)
      continue;
    leaving.push_back({there, material, {}});
    particles.copy_state(p, leaving.back().state.data());
    particles.remove(p);
  }
}


void Particles::sort(TileGrid &grid)
{
  std::vector<LeavingParticle> leaving;
  std::map<unsigned int, std::vector<LeavingParticle>> outgoing;
  const MPI_Comm communicator = grid.communicator();
  const unsigned int me =
    dealii::Utilities::MPI::this_mpi_process(communicator);
  bool changed = grid.sources().size() != tiles_.size();
  std::string problem;
  try
  {
    for (auto &tile : tiles_)
      for (unsigned int m = 0; m < n_materials_; ++m)
        remove_leaving(grid, tile.first, m, leaving);
    for (const LeavingParticle &one : leaving)
      if (const unsigned int rank = grid.owner(one.tile); rank != me)
        outgoing[rank].push_back(one);
  }
  catch (const NumericsError &error)
  {
    problem = error.what();
  }
  require_none(problem, communicator);
  for (const LeavingParticle &one : leaving)
    if (grid.owner(one.tile) == me)
    {
      changed = changed || tiles_.count(one.tile) == 0;
      block(one.tile, one.material).append(one.state.data());
    }
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
    for (const auto &from :
         dealii::Utilities::MPI::some_to_some(communicator, outgoing))
      for (const LeavingParticle &one : from.second)
      {
        changed = changed || tiles_.count(one.tile) == 0;
        block(one.tile, one.material).append(one.state.data());
      }
  for (auto tile = tiles_.begin(); tile != tiles_.end();)
  {
    std::size_t n = 0;
    for (const ParticleBlock &one : tile->second)
      n += one.size();
    changed = changed || n == 0;
    tile = n == 0 ? tiles_.erase(tile) : std::next(tile);
  }
  if (dealii::Utilities::MPI::max(changed ? 1 : 0, communicator) == 0)
    return;
  std::vector<TileGrid::TileId> sources;
  for (const auto &tile : tiles_)
    sources.push_back(tile.first);
  grid.activate(sources);
}
} // namespace contrecoup::mpm

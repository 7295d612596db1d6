// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_block.h>
#include <contrecoup/mpm/tile_grid.h>

#include <map>
#include <vector>

namespace contrecoup::mpm
{
/// The particles of this rank, by tile and material.
class Particles
{
public:
  /// The particles of a tile, by material.
  using TileBlocks = std::vector<ParticleBlock>;
  using Tiles = std::map<TileGrid::TileId, TileBlocks>;

  explicit Particles(const unsigned int n_materials = 0)
    : n_materials_(n_materials)
  {}

  unsigned int n_materials() const
  {
    return n_materials_;
  }

  /// Block of a tile of this rank; created if it does not exist.
  ParticleBlock &block(const TileGrid::TileId tile,
                       const unsigned int material);

  /// All tiles with their particles, sorted by id like TileGrid::sources()
  /// after activate().
  Tiles &tiles()
  {
    return tiles_;
  }
  const Tiles &tiles() const
  {
    return tiles_;
  }

  /// Number of particles of this rank.
  std::size_t size() const;

  /**
   * Moves particles to the tiles, and ranks, that contain them now, and creates
   * the grid nodes that they need.
   * @throws NumericsError when a particle has left the grid. Collective.
   */
  void sort(TileGrid &grid);

  /// Calls @p work(material, block) for all blocks.
  template <typename Work>
  void for_each_block(const Work &work)
  {
    for (auto &tile : tiles_)
      for (unsigned int m = 0; m < n_materials_; ++m)
        if (tile.second[m].size() > 0)
          work(m, tile.second[m]);
  }
  template <typename Work>
  void for_each_block(const Work &work) const
  {
    for (const auto &tile : tiles_)
      for (unsigned int m = 0; m < n_materials_; ++m)
        if (tile.second[m].size() > 0)
          work(m, tile.second[m]);
  }

private:
  struct LeavingParticle;
  void remove_leaving(const TileGrid &grid,
                      const TileGrid::TileId tile,
                      const unsigned int material,
                      std::vector<LeavingParticle> &leaving);

  unsigned int n_materials_;
  Tiles tiles_;
};
} // namespace contrecoup::mpm

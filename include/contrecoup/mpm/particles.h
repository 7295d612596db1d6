// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_block.h>
#include <contrecoup/mpm/tile_grid.h>

#include <map>
#include <vector>

namespace contrecoup::mpm
{
/// The particles of this rank: by tile and material.
class Particles
{
public:
  /// Of a tile, by material.
  using TileBlocks = std::vector<ParticleBlock>;
  using Tiles = std::map<TileGrid::TileId, TileBlocks>;

  explicit Particles(const unsigned int n_materials = 0)
    : n_materials_(n_materials)
  {}

  unsigned int n_materials() const
  {
    return n_materials_;
  }

  /// The block of a tile of this rank, which is made if it is not there.
  ParticleBlock &block(const TileGrid::TileId tile,
                       const unsigned int material);

  /// By their ids, as the sources of the grid are once it is active.
  Tiles &tiles()
  {
    return tiles_;
  }
  const Tiles &tiles() const
  {
    return tiles_;
  }

  /// Of this rank.
  std::size_t size() const;

  /**
   * Gives particles to the tiles that they went to, on whatever rank, and the
   * grid the nodes that they need.
   * @throws NumericsError when a particle left the grid. Collective.
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

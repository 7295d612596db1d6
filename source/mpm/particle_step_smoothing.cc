// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/particle_step.h>

#include <map>

namespace contrecoup::mpm
{
void ParticleStep::deposit_smoothed(const TileGrid &grid,
                                    Particles &particles,
                                    const unsigned int m,
                                    const bool is_pressure,
                                    NodeValues &sums) const
{
  Window window(2 * window_stride);
  std::vector<double> weight, value;
  for (const Tile &tile : tiles(grid.sources(), particles, {m}))
  {
    const ParticleBlock &block = (*tile.second)[m];
    weight.resize(block.size());
    value.resize(block.size());
    for (std::size_t p = 0; p < block.size(); ++p)
    {
      weight[p] =
        block[column::volume][p] * (1. + block[column::dilatation][p]);
      value[p] = is_pressure ? block[column::pressure][p]
                             : block[column::velocity_gradient][p] +
                                 block[column::velocity_gradient + 4][p] +
                                 block[column::velocity_gradient + 8][p];
    }
    window.fill(0.);
    deposit_scalar(block,
                   weight.data(),
                   value.data(),
                   window_geometry(grid, *tile.first),
                   window.data());
    add_window(*tile.first, window.data(), 0, {0, 0}, sums);
  }
}


void ParticleStep::smooth(const TileGrid &grid,
                          Particles &particles,
                          const bool is_pressure) const
{
  std::map<unsigned int, NodeValues> sums; // by group
  for (unsigned int m = 0; m < materials_.size(); ++m)
    if (materials_[m].is_smoothed)
    {
      const auto group = sums.emplace(materials_[m].smoothing_group, 2);
      NodeValues &values = group.first->second;
      if (group.second)
        values.clear(grid);
      deposit_smoothed(grid, particles, m, is_pressure, values);
    }
  for (auto &group : sums)
    group.second.compress_add(grid);
  for (auto &group : sums)
  {
    NodeValues &values = group.second;
    for (std::size_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
      values[1][n] = values[0][n] > 0. ? values[1][n] / values[0][n] : 0.;
    values.update_ghost_values(grid);
  }
  for (unsigned int m = 0; m < materials_.size(); ++m)
    if (materials_[m].is_smoothed)
      collect_smoothed(
        grid, particles, m, sums.at(materials_[m].smoothing_group));
}


void ParticleStep::collect_smoothed(const TileGrid &grid,
                                    Particles &particles,
                                    const unsigned int m,
                                    const NodeValues &values) const
{
  Window window(window_stride);
  for (const Tile &tile : tiles(grid.sources(), particles, {m}))
  {
    ParticleBlock &block = (*tile.second)[m];
    read_window(*tile.first, values, 1, {0}, window.data());
    collect_scalar(window.data(),
                   window_geometry(grid, *tile.first),
                   block,
                   block[column::smoothed]);
  }
}
} // namespace contrecoup::mpm

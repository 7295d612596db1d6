// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/seeding.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace contrecoup::mpm
{
namespace
{
  constexpr unsigned int n_samples = 8;

  /// A box with at most one particle of each material.
  struct SeedBox
  {
    dealii::Point<3> lower;
    std::array<double, 3> edges;

    dealii::Point<3> at(const double x, const double y, const double z) const
    {
      return {lower[0] + x * edges[0],
              lower[1] + y * edges[1],
              lower[2] + z * edges[2]};
    }
    double volume() const
    {
      return edges[0] * edges[1] * edges[2];
    }
  };

  /// Number of samples of a material in a box, and the sum of their positions.
  struct BoxSample
  {
    unsigned int count = 0;
    dealii::Tensor<1, 3> sum;
  };

  /// Whether one material fills a box. @param material that at its centre
  bool
  is_uniform(const SeedBox &box, const ParticleSource &source, int &material)
  {
    // Slightly inside, so that sides that coincide with surfaces do not count.
    constexpr double ends[] = {1e-6, 1. - 1e-6};
    material = source.material_at(box.at(0.5, 0.5, 0.5));
    for (const double z : ends)
      for (const double y : ends)
        for (const double x : ends)
          if (source.material_at(box.at(x, y, z)) != material)
            return false;
    return true;
  }

  std::map<int, BoxSample> sample(const SeedBox &box,
                                  const ParticleSource &source)
  {
    std::map<int, BoxSample> samples;
    for (unsigned int k = 0; k < n_samples; ++k)
      for (unsigned int j = 0; j < n_samples; ++j)
        for (unsigned int i = 0; i < n_samples; ++i)
        {
          const auto place = box.at((i + 0.5) / n_samples,
                                    (j + 0.5) / n_samples,
                                    (k + 0.5) / n_samples);
          BoxSample &sample_of_material = samples[source.material_at(place)];
          ++sample_of_material.count;
          sample_of_material.sum += place;
        }
    return samples;
  }

  void add_particle(const std::vector<ParticleMaterial> &materials,
                    const ParticleSource &source,
                    const unsigned int material,
                    const dealii::Point<3> &place,
                    const double volume,
                    ParticleBlock &block)
  {
    const std::size_t p = block.append();
    const auto velocity = source.velocity_at(place, material);
    for (unsigned int d = 0; d < 3; ++d)
    {
      block[column::position + d][p] = place[d];
      block[column::initial_position + d][p] = place[d];
      block[column::velocity + d][p] = velocity[d];
    }
    // Matter that is compressed at the start has a larger undeformed volume.
    const double dilatation =
      source.dilatation_at ? source.dilatation_at(place, material) : 0.;
    block[column::dilatation][p] = dilatation;
    block[column::volume][p] = volume / (1. + dilatation);
    block[column::mass][p] =
      block[column::volume][p] * materials[material].density();
  }

  void seed_box(const std::vector<ParticleMaterial> &materials,
                const ParticleSource &source,
                const SeedBox &box,
                const TileGrid::TileId tile,
                Particles &particles)
  {
    int material;
    if (is_uniform(box, source, material))
    {
      if (material != ParticleSource::none)
        add_particle(materials,
                     source,
                     material,
                     box.at(0.5, 0.5, 0.5),
                     box.volume(),
                     particles.block(tile, material));
      return;
    }
    constexpr double all = n_samples * n_samples * n_samples;
    for (const auto &[found, sample_of_material] : sample(box, source))
      if (found != ParticleSource::none)
        add_particle(
          materials,
          source,
          found,
          dealii::Point<3>(sample_of_material.sum / sample_of_material.count),
          box.volume() * sample_of_material.count / all,
          particles.block(tile, found));
  }
} // namespace


unsigned int tile_weight(const GridBox &box,
                         const ParticleSource &source,
                         const dealii::Point<3> &lower)
{
  constexpr int edge = TileGrid::tile_edge;
  constexpr unsigned int n_cells = edge * edge * edge;
  unsigned int count = 0;
  std::set<int> materials;
  for (int k = 0; k < edge; ++k)
    for (int j = 0; j < edge; ++j)
      for (int i = 0; i < edge; ++i)
      {
        dealii::Point<3> place = lower;
        const int cell[] = {i, j, k};
        bool inside = true;
        for (unsigned int d = 0; d < 3; ++d)
        {
          place[d] += (cell[d] + 0.5) * box.cell_size;
          inside =
            inside && place[d] < box.lower[d] + box.cell_size * box.n_cells[d];
        }
        const int material =
          inside ? source.material_at(place) : ParticleSource::none;
        if (material == ParticleSource::none)
          continue;
        ++count;
        materials.insert(material);
      }
  // Each material has its own window, which costs as much as a few cells with
  // particles.
  constexpr unsigned int cells_of_window = 4;
  const unsigned int work = count + cells_of_window * materials.size();
  return std::min(1000u, 1000 * work / (n_cells + cells_of_window));
}


void seed(const std::vector<ParticleMaterial> &materials,
          const ParticleSource &source,
          TileGrid &grid,
          Particles &particles)
{
  constexpr int edge = TileGrid::tile_edge;
  const auto &n = source.per_cell;
  for (const auto tile : grid.own_tiles())
  {
    const auto origin = grid.origin(tile);
    const double size = grid.box().cell_size;
    const int ends[] = {edge * int(n[0]), edge * int(n[1]), edge * int(n[2])};
    for (int k = 0; k < ends[2]; ++k)
      for (int j = 0; j < ends[1]; ++j)
        for (int i = 0; i < ends[0]; ++i)
        {
          const int at[] = {i, j, k};
          SeedBox box;
          for (unsigned int d = 0; d < 3; ++d)
          {
            box.edges[d] = size / n[d];
            box.lower[d] =
              grid.box().lower[d] + size * origin[d] + box.edges[d] * at[d];
          }
          const auto middle = box.at(0.5, 0.5, 0.5);
          if (grid.is_inside(grid.cell_at(middle)) &&
              grid.tile_at(middle) == tile)
            seed_box(materials, source, box, tile, particles);
        }
  }
  particles.sort(grid);
}
} // namespace contrecoup::mpm

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_material.h>
#include <contrecoup/mpm/particles.h>
#include <contrecoup/mpm/tile_grid.h>

#include <deal.II/base/tensor.h>

#include <functional>
#include <vector>

namespace contrecoup::mpm
{
/// What is where at the start.
struct ParticleSource
{
  /// No material.
  static constexpr int none = -1;

  /// Number of the material at a place, or none.
  std::function<int(const dealii::Point<3> &)> material_at;
  /// [m/s]
  std::function<dealii::Tensor<1, 3>(const dealii::Point<3> &,
                                     const unsigned int material)>
    velocity_at;
  /// J - 1 that the pressure at the start makes.
  std::function<double(const dealii::Point<3> &, const unsigned int material)>
    dilatation_at;
  /// Particles of a cell along each direction.
  std::array<unsigned int, 3> per_cell{{2, 2, 2}};
};

/// Work that a tile makes, from 0 to 1000: of particles, and of each material.
unsigned int tile_weight(const GridBox &box,
                         const ParticleSource &source,
                         const dealii::Point<3> &lower);

/**
 * Whether one of some materials is within a margin of a cube, by samples.
 * @param is_chosen by material
 * @param margin,spacing of the samples [m]
 */
bool is_near_material(const ParticleSource &source,
                      const std::vector<bool> &is_chosen,
                      const dealii::Point<3> &lower,
                      const double edge,
                      const double margin,
                      const double spacing);

/**
 * Fills the tiles of this rank: every cell is cut into per_cell equal boxes,
 * and each of its materials gets a particle in their centre of mass there, with
 * their part of the volume. Boxes whose corners differ are sampled at 8^3
 * places, so that a smooth surface's volume is exact to the third order in the
 * spacing of samples. Collective.
 */
void seed(const std::vector<ParticleMaterial> &materials,
          const ParticleSource &source,
          TileGrid &grid,
          Particles &particles);
} // namespace contrecoup::mpm

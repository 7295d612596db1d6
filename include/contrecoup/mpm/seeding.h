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
/// Materials and their state at the start.
struct ParticleSource
{
  /// Result of material_at() outside of all materials.
  static constexpr int none = -1;

  /// Number of the material at a position [m], or none.
  std::function<int(const dealii::Point<3> &)> material_at;
  /// Initial velocity [m/s].
  std::function<dealii::Tensor<1, 3>(const dealii::Point<3> &,
                                     const unsigned int material)>
    velocity_at;
  /// J - 1 due to the initial pressure [-].
  std::function<double(const dealii::Point<3> &, const unsigned int material)>
    dilatation_at;
  /// Number of particles per cell along each direction.
  std::array<unsigned int, 3> per_cell{{2, 2, 2}};
};

/// Relative work of a tile, from 0 to 1000: a contribution for its particles
/// and one for each of its materials.
unsigned int tile_weight(const GridBox &box,
                         const ParticleSource &source,
                         const dealii::Point<3> &lower);

/**
 * Fills the tiles of this rank with particles. Every cell is divided into
 * per_cell equal boxes; each material within a box gets one particle at the
 * material's centre of mass there, with its volume in the box. Boxes whose
 * corners lie in different materials are sampled at 8^3 points, so that the
 * volume of a body with a smooth surface is third-order accurate in the spacing
 * of the sample points. Collective.
 */
void seed(const std::vector<ParticleMaterial> &materials,
          const ParticleSource &source,
          TileGrid &grid,
          Particles &particles);
} // namespace contrecoup::mpm

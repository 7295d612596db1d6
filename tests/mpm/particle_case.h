// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_step.h>

#include <functional>

namespace contrecoup::mpm
{
/// Particles in a box of a few cells, and steps of equal size.
class ParticleCase
{
public:
  /// The material at a place, or -1 for none.
  using Matter = std::function<int(const dealii::Point<3> &)>;
  using Velocity =
    std::function<dealii::Tensor<1, 3>(const dealii::Point<3> &)>;

  ParticleCase(const GridBox &box,
               const TransferScheme &scheme,
               const std::vector<ParticleMaterial> &materials,
               const MPI_Comm communicator = MPI_COMM_WORLD)
    : step(scheme, materials)
    , particles(materials.size())
  {
    grid.reinit(box, communicator, {});
  }

  /// Fills tiles of this rank with n particles a cell and direction.
  void fill(const Matter &matter,
            const Velocity &velocity,
            const std::array<unsigned int, 3> &n = {{2, 2, 2}})
  {
    const GridBox &box = grid.box();
    for (const auto tile : grid.own_tiles())
    {
      const auto origin = grid.origin(tile);
      const double size = grid.levels().cell_size(grid.levels().level(tile));
      const int edge = TileGrid::tile_edge;
      for (int k = 0; k < edge * int(n[2]); ++k)
        for (int j = 0; j < edge * int(n[1]); ++j)
          for (int i = 0; i < edge * int(n[0]); ++i)
          {
            const int at[] = {i, j, k};
            dealii::Point<3> x;
            double volume = 1.;
            for (unsigned int d = 0; d < 3; ++d)
            {
              x[d] = box.lower[d] + size * (origin[d] + (at[d] + 0.5) / n[d]);
              volume *= size / n[d];
            }
            if (!grid.is_inside(grid.cell_at(x)) || grid.tile_at(x) != tile)
              continue;
            const int material = matter(x);
            if (material < 0)
              continue;
            ParticleBlock &block = particles.block(tile, material);
            const std::size_t p = block.append();
            const auto v = velocity(x);
            for (unsigned int d = 0; d < 3; ++d)
            {
              block[column::position + d][p] = x[d];
              block[column::velocity + d][p] = v[d];
            }
            block[column::volume][p] = volume;
            block[column::mass][p] =
              volume * step.materials()[material].density();
          }
    }
    particles.sort(grid);
    step.start(grid, particles);
  }

  /// Goes to a time by a Courant number.
  void run(const double end,
           const double courant,
           const std::function<void()> &after = {})
  {
    const double size = courant * step.signal_time(grid, particles);
    while (time < end * (1. - 1e-12))
    {
      time += step.advance(grid,
                           particles,
                           std::min(size, end - time),
                           5,
                           [](unsigned int, ParticleBlock &) {});
      ++n_steps;
      if (after)
        after();
    }
  }

  ParticleTotals totals() const
  {
    return step.totals(grid, particles);
  }

  /// Energy that is missing, losses of the transfer counted.
  double residual(const ParticleTotals &start) const
  {
    const ParticleTotals now = totals();
    const auto sum = [&](const double value) {
      return dealii::Utilities::MPI::sum(value, grid.communicator());
    };
    return now.kinetic_energy + now.internal_energy - start.kinetic_energy -
           start.internal_energy - sum(step.ledger().external_work) +
           sum(step.ledger().transfer_loss);
  }

  TileGrid grid;
  ParticleStep step;
  Particles particles;
  double time = 0.;
  unsigned int n_steps = 0;
};

/// An elastic solid of Young's modulus and Poisson's ratio.
inline ParticleMaterial
elastic(const double young, const double poisson, const double density)
{
  SolidMaterial solid;
  solid.density = density;
  solid.bulk_modulus = young / (3. * (1. - 2. * poisson));
  solid.instantaneous_shear = young / (2. * (1. + poisson));
  ParticleMaterial material;
  material.name = "solid";
  material.law = solid;
  return material;
}
} // namespace contrecoup::mpm

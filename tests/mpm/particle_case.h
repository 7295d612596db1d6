// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_step.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace contrecoup::mpm
{
/// Mass, place and velocity of a particle.
using ParticleState = std::array<double, 7>;

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
      const double size = box.cell_size;
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
    start();
  }

  /// Adds a particle of the first material; start() is to follow.
  void add(const dealii::Point<3> &x,
           const dealii::Tensor<1, 3> &v,
           const double mass,
           const double volume)
  {
    ParticleBlock &block = particles.block(grid.tile_at(x), 0);
    const std::size_t p = block.append();
    for (unsigned int d = 0; d < 3; ++d)
    {
      block[column::position + d][p] = x[d];
      block[column::velocity + d][p] = v[d];
    }
    block[column::mass][p] = mass;
    block[column::volume][p] = volume;
  }

  /// Makes ready for steps. Collective.
  void start()
  {
    particles.sort(grid);
    step.start(grid, particles);
  }

  /// Makes masses differ a little by where particles are, so that these can be
  /// told apart.
  void tell_apart()
  {
    particles.for_each_block([](unsigned int, ParticleBlock &block) {
      for (std::size_t p = 0; p < block.size(); ++p)
        block[column::mass][p] *= 1. + 1e-3 * block[column::position][p] +
                                  1e-5 * block[column::position + 1][p] +
                                  1e-7 * block[column::position + 2][p];
    });
  }

  /// Those of all ranks, by mass. Collective.
  std::vector<ParticleState> sorted_states() const
  {
    std::vector<ParticleState> own, all;
    for_each_particle([&](const ParticleBlock &block, const std::size_t p) {
      ParticleState &state = own.emplace_back();
      state[0] = block[column::mass][p];
      for (unsigned int c = 0; c < 6; ++c)
        state[1 + c] = block[column::position + c][p];
    });
    for (const auto &from :
         dealii::Utilities::MPI::all_gather(grid.communicator(), own))
      all.insert(all.end(), from.begin(), from.end());
    std::sort(all.begin(), all.end());
    return all;
  }

  /// Calls @p work(block, particle) for all of this rank.
  template <typename Work>
  void for_each_particle(const Work &work) const
  {
    particles.for_each_block([&](unsigned int, const ParticleBlock &block) {
      for (std::size_t p = 0; p < block.size(); ++p)
        work(block, p);
    });
  }

  /// The sum of @p term(block, particle) over those of this rank.
  template <typename Term>
  double sum(const Term &term) const
  {
    double result = 0.;
    for_each_particle([&](const ParticleBlock &block, const std::size_t p) {
      result += term(block, p);
    });
    return result;
  }

  /// Goes some steps of one size, without retries and forces from outside.
  void advance(const double size, const unsigned int n = 1)
  {
    for (unsigned int i = 0; i < n; ++i)
      step.advance(
        grid, particles, size, 0, [](unsigned int, ParticleBlock &) {});
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

/// The largest difference between numbers of particles in the same order.
inline double largest_difference(const std::vector<ParticleState> &a,
                                 const std::vector<ParticleState> &b)
{
  double largest = 0.;
  for (std::size_t p = 0; p < a.size(); ++p)
    for (unsigned int c = 0; c < a[p].size(); ++c)
      largest = std::max(largest, std::abs(a[p][c] - b[p][c]));
  return largest;
}

/// One cell of 1 m.
inline TileGrid unit_cell()
{
  TileGrid grid;
  grid.reinit(GridBox(), MPI_COMM_SELF, {});
  return grid;
}

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

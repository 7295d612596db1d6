// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/rezone/remap.h>

#include "mesh_motions.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::ale;

namespace
{
constexpr unsigned int width = node_width;

struct Errors
{
  double density = 0., velocity = 0.;
};

/// Means over cells of how far linear or wavy fields are off after remaps
/// there and back, and somewhere else.
Errors errors(const unsigned int n, const bool linear)
{
  Slab slab({n, n, n}, 1.);
  const auto density = [&](const dealii::Point<3> &x) {
    return linear ? 2. + 0.3 * x[0] - 0.2 * x[1] + 0.5 * x[2]
                  : 2. + std::sin(3. * x[0]) * std::cos(2. * x[1] + x[2]);
  };
  const auto velocity = [&](const double *x, const unsigned int d) {
    return linear ? 1. + 0.1 * d + 0.7 * x[(d + 1) % 3]
                  : std::sin(2. * x[d] + x[(d + 1) % 3]);
  };
  const auto mean = [&](const std::size_t c) {
    return mean_of(slab, c, density);
  };
  for (std::size_t c = 0; c < slab.space.n_cells(); ++c)
    slab.state.mass[c] = mean(c) * hex_moments(slab.corners(c)).volume;
  for (std::size_t c = 0; c < slab.space.n_cells(); ++c)
    slab.state.energy[c] = slab.state.mass[c];
  slab.step.start(slab.state);
  SlipWalls none;
  none.reinit(slab.space, slab.state.position, {});
  for (std::size_t i = 0; i < slab.space.n_nodes(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      slab.state.velocity[width * i + d] =
        velocity(&slab.state.position[width * i], d);
  Remap remap;
  remap.reinit(slab.space);
  for (unsigned int i = 1; i <= 4; ++i)
    remap.apply(slab.state, none, wavy(slab, 0.2 / n, i));
  Errors result;
  for (std::size_t c = 0; c < slab.space.n_locally_owned_cells(); ++c)
    result.density +=
      std::abs(slab.state.mass[c] / hex_moments(slab.corners(c)).volume -
               mean(c)) /
      slab.space.n_locally_owned_cells();
  for (std::size_t i = 0; i < slab.space.n_locally_owned_nodes(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      result.velocity +=
        std::abs(slab.state.velocity[width * i + d] -
                 velocity(&slab.state.position[width * i], d)) /
        slab.space.n_locally_owned_nodes();
  result.density = dealii::Utilities::MPI::max(result.density, MPI_COMM_WORLD);
  result.velocity =
    dealii::Utilities::MPI::max(result.velocity, MPI_COMM_WORLD);
  return result;
}
} // namespace

TEST(Remap, keeps_uniform_states_and_velocities_of_nodes_at_rest)
{
  Slab slab({6, 5, 4}, 1.);
  slab.fill([](const dealii::Point<3> &) { return SlabGas{1.3, 0.7}; });
  Remap remap;
  remap.reinit(slab.space);
  for (unsigned int i = 1; i <= 20; ++i)
    remap.apply(slab.state,
                slab.step.walls(),
                i % 2 == 0 ? shaken(slab, 0.04) : wavy(slab, 0.03, i % 3 + 1));
  for (std::size_t c = 0; c < slab.space.n_locally_owned_cells(); ++c)
  {
    const double volume = hex_moments(slab.corners(c)).volume;
    EXPECT_NEAR(slab.state.mass[c] / volume, 1.3, 1e-13);
    EXPECT_NEAR(slab.state.energy[c] / volume, 0.7 / 0.4, 1e-13);
  }
  for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
    for (unsigned int d = 0; d < 3; ++d)
      slab.state.velocity[width * n + d] =
        std::sin(3. * slab.space.node_number(n) + d);
  slab.step.walls().apply(slab.state.velocity, 0.);
  const auto before = slab.state.velocity;
  const auto position = slab.state.position;
  for (unsigned int i = 0; i < 10; ++i)
    remap.apply(slab.state, slab.step.walls(), position);
  for (std::size_t i = 0; i < before.size(); ++i)
    if (i % width < 3)
    {
      EXPECT_NEAR(slab.state.velocity[i], before[i], 1e-13);
    }
}

TEST(Remap, keeps_velocities_over_ten_thousand_cycles_at_rest)
{
  Slab slab({3, 2, 2}, 1.);
  slab.fill([](const dealii::Point<3> &x) {
    return SlabGas{x[0] < 0.4 ? 1000. : 1., 1.};
  });
  for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
    for (unsigned int d = 0; d < 3; ++d)
      slab.state.velocity[width * n + d] =
        std::sin(3. * slab.space.node_number(n) + d);
  slab.step.walls().apply(slab.state.velocity, 0.);
  Remap remap;
  remap.reinit(slab.space);
  const auto before = slab.state;
  const auto totals = slab.totals();
  const double energy = totals.internal_energy + totals.kinetic_energy;
  // On several ranks, waiting for each other would take most of the time.
  const bool alone =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
  const unsigned int n_cycles = alone ? 10000 : 100;
  for (unsigned int i = 0; i < n_cycles; ++i)
    remap.apply(slab.state, slab.step.walls(), before.position);
  for (std::size_t i = 0; i < before.velocity.size(); ++i)
    if (i % width < 3)
    {
      EXPECT_NEAR(slab.state.velocity[i], before.velocity[i], 1e-12);
    }
  for (std::size_t c = 0; c < slab.space.n_locally_owned_cells(); ++c)
    EXPECT_NEAR(slab.state.energy[c], before.energy[c], 1e-12 * energy);
}

// The kinetic energy lost in mixing depends on velocity differences alone.
TEST(Remap, heats_alike_in_every_moving_frame)
{
  std::vector<std::vector<double>> energies;
  for (const double speed : {0., 300.})
  {
    Slab slab({6, 5, 4}, 1.);
    slab.fill([](const dealii::Point<3> &x) {
      return SlabGas{x[0] < 0.4 ? 5. : 1., 1. + x[1]};
    });
    for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
      for (unsigned int d = 0; d < 3; ++d)
        slab.state.velocity[width * n + d] =
          speed * (1. - 0.7 * d) +
          std::sin(17. * slab.space.node_number(n) + d);
    SlipWalls none;
    none.reinit(slab.space, slab.state.position, {});
    Remap remap;
    remap.reinit(slab.space);
    for (unsigned int i = 1; i <= 3; ++i)
      remap.apply(slab.state, none, wavy(slab, 0.05, i));
    energies.emplace_back(slab.state.energy.begin(),
                          slab.state.energy.begin() +
                            slab.space.n_locally_owned_cells());
  }
  for (std::size_t c = 0; c < energies[0].size(); ++c)
    EXPECT_NEAR(energies[1][c], energies[0][c], 1e-9 * energies[0][c]);
}

TEST(Remap, keeps_mass_momentum_and_total_energy)
{
  Slab slab({6, 6, 6}, 1.);
  slab.fill([](const dealii::Point<3> &x) {
    return SlabGas{x[0] < 0.4 ? 5. : 1., 1. + x[1]};
  });
  for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
    for (unsigned int d = 0; d < 3; ++d)
      slab.state.velocity[width * n + d] =
        std::sin(17. * slab.space.node_number(n) + d);
  SlipWalls none;
  none.reinit(slab.space, slab.state.position, {});
  Remap remap;
  remap.reinit(slab.space);
  for (unsigned int i = 1; i <= 5; ++i)
  {
    const auto before = slab.totals();
    remap.apply(slab.state, none, wavy(slab, 0.05, i % 3 + 1));
    const auto after = slab.totals();
    EXPECT_NEAR(after.mass, before.mass, 1e-14 * before.mass);
    EXPECT_NEAR(
      (after.momentum - before.momentum).norm(), 0., 1e-14 * before.mass);
    const double energy = before.internal_energy + before.kinetic_energy;
    EXPECT_NEAR(
      after.internal_energy + after.kinetic_energy, energy, 1e-14 * energy);
    EXPECT_LT(after.kinetic_energy, before.kinetic_energy);
  }
}

TEST(Remap, is_exact_for_linear_densities_and_of_second_order)
{
  EXPECT_LT(errors(6, true).density, 1e-13);
  const Errors coarse = errors(8, false), fine = errors(16, false);
  EXPECT_GT(std::log2(coarse.density / fine.density), 1.9);
  EXPECT_GT(std::log2(coarse.velocity / fine.velocity), 1.9);
}

// A step of density, carried to and fro: nothing beyond what was there.
TEST(Remap, makes_no_new_extrema)
{
  Slab slab({8, 8, 8}, 1.);
  slab.fill([](const dealii::Point<3> &x) {
    return SlabGas{x[0] + x[1] < 0.8 ? 1. : 3., 1.};
  });
  Remap remap;
  remap.reinit(slab.space);
  for (unsigned int i = 1; i <= 30; ++i)
    remap.apply(slab.state, slab.step.walls(), wavy(slab, 0.03, i % 3 + 1));
  for (std::size_t c = 0; c < slab.space.n_locally_owned_cells(); ++c)
  {
    const double volume = hex_moments(slab.corners(c)).volume;
    EXPECT_GT(slab.state.mass[c] / volume, 1. - 1e-4) << slab.centre(c);
    EXPECT_LT(slab.state.mass[c] / volume, 3. + 3e-3);
  }
}

// Cells in a row, five hundred times as wide as long, whose centres are a
// little off the line: what that says of gradients across the line is noise.
TEST(Remap, makes_no_new_extrema_in_flat_cells_in_a_row)
{
  Slab slab({40, 1, 1}, 1., {}, 0., [](const dealii::Point<3> &x) {
    const double off = x[1] > 0. ? 1e-8 * std::sin(1234. * x[0]) : 0.;
    return dealii::Point<3>(x[0], 500. * x[1] + off, 500. * x[2]);
  });
  slab.fill([](const dealii::Point<3> &x) {
    return SlabGas{x[0] < 0.5 ? 1. : 3., 1.};
  });
  Remap remap;
  remap.reinit(slab.space);
  const auto home = slab.state.position;
  for (unsigned int i = 1; i <= 30; ++i)
  {
    auto position = home;
    for (double *x = position.begin(); x < position.end(); x += width)
      if (*x > 1e-6 && *x < 1. - 1e-6)
        *x += 0.005 * std::sin(7. * i * x[0]) + 1e-8 * std::sin(i * x[1]);
    remap.apply(slab.state, slab.step.walls(), position);
  }
  for (std::size_t c = 0; c < slab.space.n_locally_owned_cells(); ++c)
  {
    const double volume = hex_moments(slab.corners(c)).volume;
    EXPECT_GT(slab.state.mass[c] / volume, 1. - 1e-3) << slab.centre(c);
    EXPECT_LT(slab.state.mass[c] / volume, 3. + 3e-3) << slab.centre(c);
  }
}

// Sod's shock tube on a mesh that is put back after each step.
TEST(Remap, keeps_a_shock_tube_on_a_mesh_at_rest)
{
  std::vector<double> errors;
  for (const unsigned int n : {50, 100})
  {
    Slab slab({n, 1, 1}, 1.);
    slab.fill([](const dealii::Point<3> &x) {
      return x[0] < 0.5 ? SlabGas{1., 1.} : SlabGas{0.125, 0.1};
    });
    const auto position = slab.state.position;
    Remap remap;
    remap.reinit(slab.space);
    const auto before = slab.totals();
    while (slab.state.time < 0.2 * (1. - 1e-12))
    {
      slab.step.advance(slab.state, 0.2 - slab.state.time, 0.3);
      remap.apply(slab.state, slab.step.walls(), position);
    }
    const auto after = slab.totals();
    EXPECT_NEAR(after.internal_energy + after.kinetic_energy,
                before.internal_energy,
                1e-13 * before.internal_energy);
    EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
    errors.push_back(slab.sod_error(0.2));
  }
  EXPECT_LT(errors[1], 0.00623);
  EXPECT_GT(std::log2(errors[0] / errors[1]), 0.7);
}

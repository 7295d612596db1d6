// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/rezone/remap.h>

#include "mesh_motions.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::ale;

namespace
{
/// The largest part of its volume that a cell loses on the way there.
double largest_outflow(const Slab &slab,
                       const dealii::AlignedVector<double> &position)
{
  std::vector<double> outflow(slab.space.n_cells());
  for (const HexSpace::Face &face : slab.space.faces())
  {
    std::array<Vector3<double>, 4> before, after;
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int d = 0; d < 3; ++d)
      {
        before[i][d] = slab.state.position[node_width * face.nodes[i] + d];
        after[i][d] = position[node_width * face.nodes[i] + d];
      }
    const double swept = swept_moments(before, after).volume;
    if (face.outside != HexSpace::no_cell)
      outflow[swept > 0. ? face.outside : face.inside] += std::abs(swept);
  }
  double largest = 0.;
  for (std::size_t c = 0; c < slab.space.n_locally_owned_cells(); ++c)
    largest =
      std::max(largest, outflow[c] / hex_moments(slab.corners(c)).volume);
  return dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);
}

/// The largest error of a density with smooth peaks after @p n remaps.
double largest_error(const unsigned int n, const RemapLimiter limiter)
{
  Slab slab({n, n, n}, 1.);
  const auto density = [](const dealii::Point<3> &x) {
    const double k = 2. * dealii::numbers::PI;
    return 2. + std::sin(k * x[0]) * std::sin(k * x[1]) * std::sin(k * x[2]);
  };
  for (std::size_t c = 0; c < slab.space.n_cells(); ++c)
  {
    slab.state.mass[c] =
      mean_of(slab, c, density) * hex_moments(slab.corners(c)).volume;
    slab.state.energy[c] = slab.state.mass[c];
  }
  slab.step.start(slab.state);
  Remap remap;
  remap.reinit(slab.space, {}, limiter);
  for (unsigned int i = 1; i <= n; ++i)
    remap.apply(slab.state, slab.step.walls(), wavy(slab, 0.2 / n, i % 4 + 1));
  double largest = 0.;
  for (std::size_t c = 0; c < slab.space.n_locally_owned_cells(); ++c)
    largest = std::max(
      largest,
      std::abs(slab.state.mass[c] / hex_moments(slab.corners(c)).volume -
               mean_of(slab, c, density)));
  return dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);
}

} // namespace

// Peaks that are smooth keep their height, but for a strict limiter, with which
// the order is 1.4 there.
TEST(RemapBounds, is_of_second_order_at_peaks_unless_strict)
{
  // On several ranks, waiting for each other would take most of the time.
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    return;
  const RemapLimiter keep = RemapLimiter::keep_smooth_extrema;
  const double fine = largest_error(16, keep);
  EXPECT_GT(std::log2(largest_error(8, keep) / fine), 1.9);
  EXPECT_GT(largest_error(16, RemapLimiter::strict), 1.4 * fine);
}

// Steps and a cone on meshes at random, by up to nine tenths of a cell at once.
TEST(RemapBounds, stays_within_all_bounds_when_strict)
{
  Slab slab({8, 8, 8}, 1.);
  slab.fill([](const dealii::Point<3> &x) {
    return SlabGas{x[0] + x[1] < 0.8 ? 1. : 3., x[2] < 0.4 ? 1. : 5.};
  });
  for (std::size_t c = 0; c < slab.space.n_cells(); ++c)
  {
    const double distance = slab.centre(c).distance({0.5, 0.5, 0.5});
    slab.state.energy[c] = slab.state.mass[c] * (distance < 0.3 ? 7. : 2.);
    slab.state.products[c] = std::max(0., 1. - 3. * distance);
  }
  Remap remap;
  remap.reinit(slab.space, {}, RemapLimiter::strict);
  const double mass = slab.totals().mass,
               energy = slab.totals().internal_energy;
  double largest = 0.;
  for (unsigned int i = 1; i <= 30; ++i)
  {
    const auto position =
      i % 3 == 0 ? wavy(slab, 0.03, i % 2 + 1) : shaken(slab, 0.36 / 8., i);
    largest = std::max(largest, largest_outflow(slab, position));
    remap.apply(slab.state, slab.step.walls(), position);
    for (std::size_t c = 0; c < slab.space.n_locally_owned_cells(); ++c)
    {
      const double density =
        slab.state.mass[c] / hex_moments(slab.corners(c)).volume;
      ASSERT_GT(density, 1. - 1e-13);
      ASSERT_LT(density, 3. + 1e-13);
      ASSERT_GT(slab.state.energy[c] / slab.state.mass[c], 2. - 1e-13);
      ASSERT_LT(slab.state.energy[c] / slab.state.mass[c], 7. + 1e-13);
      ASSERT_GT(slab.state.products[c], -1e-13);
      ASSERT_LT(slab.state.products[c], 1. + 1e-13);
    }
  }
  EXPECT_GT(largest, 0.85);
  EXPECT_LT(largest, 1.);
  EXPECT_NEAR(slab.totals().mass, mass, 1e-13 * mass);
  EXPECT_NEAR(slab.totals().internal_energy, energy, 1e-13 * energy);
}

// Components of velocities that jump where the density does, too.
TEST(RemapBounds, bounds_velocities_when_strict)
{
  Slab slab({6, 6, 6}, 1.);
  slab.fill([](const dealii::Point<3> &x) {
    return SlabGas{x[0] < 0.4 ? 100. : 1., 1.};
  });
  SlipWalls none;
  none.reinit(slab.space, slab.state.position, {});
  for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double *const x = &slab.state.position[node_width * n];
      slab.state.velocity[node_width * n + d] = x[d] + x[0] < 0.7 ? 2. + d : 7.;
    }
  const auto totals = slab.totals();
  Remap remap;
  remap.reinit(slab.space, {}, RemapLimiter::strict);
  for (unsigned int i = 1; i <= 20; ++i)
  {
    remap.apply(slab.state, none, shaken(slab, 0.15 / 6., i));
    for (std::size_t n = 0; n < slab.space.n_locally_owned_nodes(); ++n)
      for (unsigned int d = 0; d < 3; ++d)
      {
        ASSERT_GT(slab.state.velocity[node_width * n + d], 2. + d - 1e-13);
        ASSERT_LT(slab.state.velocity[node_width * n + d], 7. + 1e-13);
      }
  }
  const auto after = slab.totals();
  EXPECT_NEAR(
    (after.momentum - totals.momentum).norm(), 0., 1e-12 * totals.mass);
  const double energy = totals.internal_energy + totals.kinetic_energy;
  EXPECT_NEAR(
    after.internal_energy + after.kinetic_energy, energy, 1e-13 * energy);
}

// A cell loses nine tenths of its volume through one face, and the density
// beyond it is a thousandfold: masses stay positive, and nothing is beyond what
// was.
TEST(RemapBounds, bears_large_motion_at_a_thousandfold_density)
{
  for (const auto limiter :
       {RemapLimiter::keep_smooth_extrema, RemapLimiter::strict})
  {
    Slab slab({20, 2, 2}, 1.);
    slab.fill([](const dealii::Point<3> &x) {
      return SlabGas{x[0] < 0.5 ? 1000. : 1., 1.};
    });
    const auto home = slab.state.position;
    auto away = home;
    for (double *x = away.begin(); x < away.end(); x += node_width)
      if (*x > 1e-6 && *x < 1. - 1e-6)
        *x += 0.9 * 0.05;
    const double mass = slab.totals().mass;
    Remap remap;
    remap.reinit(slab.space, {}, limiter);
    for (unsigned int i = 0; i < 20; ++i)
    {
      remap.apply(slab.state, slab.step.walls(), i % 2 == 0 ? away : home);
      for (std::size_t c = 0; c < slab.space.n_locally_owned_cells(); ++c)
      {
        const double volume = hex_moments(slab.corners(c)).volume;
        EXPECT_GT(slab.state.mass[c] / volume, 1. - 1e-9);
        EXPECT_LT(slab.state.mass[c] / volume, 1000. * (1. + 1e-12));
        EXPECT_GT(slab.state.energy[c], 0.);
      }
    }
    EXPECT_NEAR(slab.totals().mass, mass, 1e-13 * mass);
  }
}

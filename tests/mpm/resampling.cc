// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/resampling.h>

#include "particle_case.h"
#include <gtest/gtest.h>

#include <random>

using namespace contrecoup::mpm;

namespace
{
/// Sums that resampling keeps: mass, volume, momentum, angular momentum, and
/// kinetic and internal energy together.
std::array<double, 9> conserved_sums(const ParticleBlock &particles)
{
  std::array<double, 9> result{};
  for (std::size_t p = 0; p < particles.size(); ++p)
  {
    dealii::Tensor<1, 3> x, v;
    for (unsigned int d = 0; d < 3; ++d)
    {
      x[d] = particles[column::position + d][p];
      v[d] = particles[column::velocity + d][p];
    }
    const double mass = particles[column::mass][p];
    const auto spin = dealii::cross_product_3d(x, v);
    result[0] += mass;
    result[1] += particles[column::volume][p];
    for (unsigned int d = 0; d < 3; ++d)
    {
      result[2 + d] += mass * v[d];
      result[5 + d] += mass * spin[d];
    }
    result[8] += 0.5 * mass * v.norm_square() + particles[column::energy][p];
  }
  return result;
}

/// Particles of random places, velocities and strains in the unit cube.
ParticleBlock shaken_particles(const std::size_t n)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0., 1.);
  ParticleBlock particles;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t p = particles.append();
    for (unsigned int d = 0; d < 3; ++d)
    {
      particles[column::position + d][p] = number(random);
      particles[column::velocity + d][p] = number(random) - 0.5;
    }
    for (unsigned int k = 0; k < 9; ++k)
      particles[column::gradient + k][p] = 3. * (number(random) - 0.5);
    particles[column::mass][p] = 1. + number(random);
    particles[column::volume][p] = 0.01;
    particles[column::energy][p] = number(random);
  }
  return particles;
}

void expect_same(const std::array<double, 9> &now,
                 const std::array<double, 9> &before)
{
  for (unsigned int i = 0; i < 9; ++i)
    EXPECT_NEAR(now[i], before[i], 1e-13 * before[0]) << i;
}
} // namespace

TEST(Resampling, split_keeps_mass_momenta_and_energy)
{
  ParticleBlock particles = shaken_particles(50);
  const auto before = conserved_sums(particles);
  const std::size_t n = split_stretched(2., particles);
  EXPECT_GT(n, 5u);
  EXPECT_EQ(particles.size(), 50 + n);
  expect_same(conserved_sums(particles), before);
}

// A particle that is three times as long: its halves have 1.5 times a cube's
// edge each and lie 3/4 of that edge from the middle. They are not split again.
TEST(Resampling, halves_lie_along_the_stretch_and_stay)
{
  ParticleBlock particles;
  particles.append();
  particles[column::gradient][0] = 2.;
  particles[column::mass][0] = particles[column::volume][0] = 1.;
  particles[column::area][0] = 1.;
  particles[column::surface][0] = 0.5;
  EXPECT_EQ(split_stretched(2., particles), 1u);
  ASSERT_EQ(particles.size(), 2u);
  for (std::size_t p = 0; p < 2; ++p)
  {
    const double x = particles[column::position][p];
    EXPECT_NEAR(std::abs(x), 0.75, 1e-14);
    // Both carry the surface at 3 * 0.5.
    EXPECT_NEAR(x + 3. * particles[column::surface][p], 1.5, 1e-14);
    EXPECT_EQ(particles[column::area][p], 0.5);
    // Undeformed, they lie a quarter of an edge from the middle.
    EXPECT_NEAR(particles[column::initial_position][p], x / 3., 1e-14);
  }
  EXPECT_EQ(split_stretched(2., particles), 0u);
  particles[column::gradient][1] = 3.;
  EXPECT_EQ(split_stretched(2., particles), 1u);
}

TEST(Resampling, merge_keeps_mass_momenta_and_energy)
{
  const TileGrid grid = unit_cell();
  ParticleBlock particles = shaken_particles(40);
  const auto before = conserved_sums(particles);
  EXPECT_GE(merge_crowded(24, grid, particles), 16u);
  EXPECT_LE(particles.size(), 24u);
  expect_same(conserved_sums(particles), before);
  for (std::size_t p = 0; p < particles.size(); ++p)
    EXPECT_GT(particles[column::energy][p], 0.);
}

// Four particles at rest make no heat; four that fly apart along their arms
// keep no spin and become heat.
TEST(Resampling, merge_turns_what_velocity_is_left_into_heat)
{
  const TileGrid grid = unit_cell();
  for (const double speed : {0., 1.})
  {
    ParticleBlock particles;
    for (unsigned int i = 0; i < 5; ++i)
    {
      const std::size_t p = particles.append();
      const double angle = 0.4 * i * dealii::numbers::PI;
      particles[column::position][p] = 0.5 + 0.2 * std::cos(angle);
      particles[column::position + 1][p] = 0.5 + 0.2 * std::sin(angle);
      particles[column::position + 2][p] = 0.5;
      particles[column::velocity][p] = speed * std::cos(angle);
      particles[column::velocity + 1][p] = speed * std::sin(angle);
      particles[column::mass][p] = particles[column::volume][p] = 1.;
    }
    const auto before = conserved_sums(particles);
    EXPECT_EQ(merge_crowded(4, grid, particles), 2u);
    expect_same(conserved_sums(particles), before);
    double heat = 0.;
    for (std::size_t p = 0; p < particles.size(); ++p)
      heat += particles[column::energy][p];
    if (speed == 0.)
      EXPECT_EQ(heat, 0.);
    else
      EXPECT_GT(heat, 1.);
  }
}

TEST(Resampling, probes_and_surfaces_stay)
{
  const TileGrid grid = unit_cell();
  ParticleBlock particles = shaken_particles(40);
  for (std::size_t p = 0; p < 40; ++p)
    particles[p % 2 == 0 ? column::probe : column::area][p] = 1.;
  EXPECT_EQ(merge_crowded(8, grid, particles), 0u);
}

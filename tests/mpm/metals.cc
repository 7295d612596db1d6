// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/resampling.h>

#include "particle_case.h"
#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;
using namespace contrecoup::mpm;

namespace
{
ParticleMaterial soft_copper()
{
  ParticleMaterial material = elastic(124e9, 0.34, 8960.);
  material.name = "copper";
  material.plasticity = JohnsonCook();
  return material;
}

/// Particles with the state of a metal, random and as long as wide.
ParticleBlock worn_particles(const std::size_t n)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<double> number(0., 1.);
  ParticleBlock particles;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t p = particles.append();
    for (unsigned int d = 0; d < 3; ++d)
      particles[column::position + d][p] = number(random);
    for (unsigned int k = 0; k < 6; ++k)
      particles[column::relaxed + k][p] = 1e-3 * number(random);
    particles[column::mass][p] = particles[column::volume][p] =
      0.01 * (1. + number(random));
    particles[column::plastic_strain][p] = number(random);
    particles[column::plastic_work][p] = 1e8 * number(random);
  }
  return particles;
}

/// Volume, and plastic strain and work by volume.
std::array<double, 3> plastic_sums(const ParticleBlock &particles)
{
  std::array<double, 3> sums{};
  for (std::size_t p = 0; p < particles.size(); ++p)
  {
    const double volume = particles[column::volume][p];
    sums[0] += volume;
    sums[1] += volume * particles[column::plastic_strain][p];
    sums[2] += volume * particles[column::plastic_work][p];
  }
  return sums;
}
} // namespace


TEST(Metals, SplitAndMergedParticlesKeepWhatTheyRemember)
{
  const TileGrid grid = unit_cell();
  ParticleBlock particles = worn_particles(40);
  const auto before = plastic_sums(particles);
  for (std::size_t p = 0; p < 40; p += 2)
    particles[column::gradient][p] = 1.5;
  EXPECT_EQ(split_stretched(2., particles), 20u);
  const std::size_t last = particles.size() - 1;
  for (unsigned int k = 0; k < 6; ++k)
    EXPECT_EQ(particles[column::relaxed + k][last],
              particles[column::relaxed + k][last - 1]);
  EXPECT_GT(particles[column::plastic_strain][last], 0.);
  auto now = plastic_sums(particles);
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(now[i], before[i], 1e-13 * before[i]);
  EXPECT_GT(merge_crowded(20, grid, particles), 20u);
  now = plastic_sums(particles);
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(now[i], before[i], 1e-13 * before[i]);
}


// Particles of one velocity gradient have the stress of one metal, with the
// pressure of its volume.
TEST(Metals, ParticlesAreStrainedAsOneMetal)
{
  const ParticleMaterial material = soft_copper();
  const SolidMaterial &solid = *material.solid();
  ParticleBlock particles;
  constexpr std::size_t n = 11;
  for (std::size_t p = 0; p < n; ++p)
  {
    particles.append();
    particles[column::volume][p] = 1.;
    const double scale = 1e4 * p;
    particles[column::velocity_gradient][p] = -scale;
    particles[column::velocity_gradient + 1][p] = 0.7 * scale;
    particles[column::velocity_gradient + 8][p] = 0.4 * scale;
  }
  constexpr double step = 2e-8;
  std::array<MetalState<double>, n> states;
  std::array<Matrix3<double>, n> f;
  double stored = 0.;
  for (std::size_t p = 0; p < n; ++p)
    f[p] = {{{{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}}};
  for (unsigned int i = 0; i < 20; ++i)
  {
    strain_particles(material, step, 0.001, particles);
    stored = 0.;
    for (std::size_t p = 0; p < n; ++p)
    {
      Matrix3<double> increment{};
      increment[0][0] = -1e4 * p * step;
      increment[0][1] = 0.7e4 * p * step;
      increment[2][2] = 0.4e4 * p * step;
      const auto deviator = strain_metal(*material.plasticity,
                                         solid.instantaneous_shear,
                                         increment,
                                         step,
                                         states[p]);
      // F is upper triangular.
      f[p][0][0] *= 1. + increment[0][0];
      f[p][2][2] *= 1. + increment[2][2];
      const double ratio = f[p][0][0] * f[p][2][2];
      const double pressure = -solid.bulk_modulus * (ratio - 1.);
      EXPECT_NEAR(particles[column::pressure][p], pressure, 1.);
      for (unsigned int k = 0; k < 6; ++k)
        EXPECT_NEAR(particles[column::stress + k][p],
                    deviator[k] - (k < 3 ? pressure * ratio : 0.),
                    1.);
      EXPECT_NEAR(
        particles[column::plastic_strain][p], states[p].plastic_strain, 1e-12);
      EXPECT_NEAR(
        particles[column::plastic_work][p], states[p].plastic_work, 1e-3);
      stored +=
        0.5 * solid.bulk_modulus * (ratio - 1.) * (ratio - 1.) +
        metal_shear_energy(solid.instantaneous_shear, states[p].elastic);
    }
  }
  EXPECT_GT(particles[column::plastic_strain][n - 1], 0.01);
  EXPECT_EQ(particles[column::plastic_strain][0], 0.);
  EXPECT_NEAR(stored_energy(material, particles), stored, 1e-9 * stored);
}


// A cube that hits a wall: what it has lost of its motion is stored or plastic
// work, but for artificial viscosity, and the ledger closes.
TEST(Metals, CrushedCubeKeepsItsEnergy)
{
  GridBox box;
  box.cell_size = 0.001;
  box.n_cells = {{12, 10, 10}};
  box.reflects[0] = true;
  TransferScheme scheme;
  scheme.series_order = 2;
  for (const bool is_smoothed : {false, true})
  {
    ParticleMaterial material = soft_copper();
    material.is_smoothed = is_smoothed;
    material.linear_viscosity = 0.06;
    material.quadratic_viscosity = 1.5;
    ParticleCase cube(box, scheme, {material}, MPI_COMM_SELF);
    cube.fill(
      [](const dealii::Point<3> &x) {
        return x[0] < 0.006 && x[1] > 0.003 && x[1] < 0.007 && x[2] > 0.003 &&
                   x[2] < 0.007
                 ? 0
                 : -1;
      },
      [](const dealii::Point<3> &) {
        return dealii::Tensor<1, 3>({-100., 0., 0.});
      });
    const auto start = cube.totals();
    cube.run(1e-5, 0.3);
    const auto end = cube.totals();
    EXPECT_NEAR(cube.residual(start), 0., 1e-12 * start.kinetic_energy);
    EXPECT_LT(end.kinetic_energy, 0.3 * start.kinetic_energy);
    double work = 0., largest = 0.;
    cube.for_each_particle(
      [&](const ParticleBlock &block, const std::size_t p) {
        work += block[column::volume][p] * block[column::plastic_work][p];
        largest = std::max(largest, block[column::plastic_strain][p]);
      });
    EXPECT_GT(largest, 0.2);
    const double lost = start.kinetic_energy - end.kinetic_energy;
    EXPECT_GT(work + end.stored_energy, 0.9 * lost);
    EXPECT_LT(work + end.stored_energy, lost);
  }
}

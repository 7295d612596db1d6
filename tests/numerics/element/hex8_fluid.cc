// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/principal_axes.h>
#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/numerics/element/hex8_fluid.h>

#include <deal.II/base/symmetric_tensor.h>

#include "hexahedra.h"
#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;

namespace
{
const IdealGas gas(1.4);

FluidElement<double> element_at_rest(const Corners &x)
{
  FluidElement<double> element{};
  element.mass = 1.2 * hex_geometry(to_modes(x)).volume;
  element.energy = 2.5 * element.mass;
  return element;
}

double power(const Corners &force, const Corners &velocity)
{
  double sum = 0.;
  for (unsigned int i = 0; i < 8; ++i)
    sum += dot(force[i], velocity[i]);
  return sum;
}

/// Velocities with this gradient.
Corners linear_field(const Corners &x, const Matrix3<double> &gradient)
{
  Corners v{};
  for (unsigned int i = 0; i < 8; ++i)
    for (unsigned int d = 0; d < 3; ++d)
      v[i][d] = dot(gradient[d], x[i]);
  return v;
}
} // namespace

TEST(Compression, finds_the_least_eigenvalue_and_its_direction)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1., 1.);
  for (unsigned int n = 0; n < 200; ++n)
  {
    Matrix3<double> gradient;
    for (auto &row : gradient)
      for (double &entry : row)
        entry = value(random);
    dealii::SymmetricTensor<2, 3> e;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        e[i][j] = 0.5 * (gradient[i][j] + gradient[j][i]);
    const auto pairs = principal_axes(e);
    const auto found = find_compression(gradient);
    const double size = e.norm();
    EXPECT_NEAR(found.norm, size, 1e-14 * size);
    EXPECT_NEAR(found.smallest_eigenvalue, pairs[2].first, 1e-6 * size);
    if (pairs[1].first - pairs[2].first < 0.2 * size)
      continue;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        EXPECT_NEAR(
          found.direction[i][j], pairs[2].second[i] * pairs[2].second[j], 1e-4);
  }
}

// As where a flow converges upon a point: all directions but one are compressed
// almost alike. The projector has no negative eigenvalue then.
TEST(Compression, finds_a_projector_for_almost_double_eigenvalues)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1., 1.);
  for (const double gap : {0., 1e-12, 1e-9, 1e-8, 1e-7})
    for (unsigned int n = 0; n < 1000; ++n)
    {
      Vector3<double> axis{{value(random), value(random), value(random)}};
      const double length = std::sqrt(dot(axis, axis));
      for (double &component : axis)
        component /= length;
      Matrix3<double> gradient;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          gradient[i][j] = (i == j ? -1. : 0.) + 0.97 * axis[i] * axis[j];
      gradient[0][0] += gap;
      const auto found = find_compression(gradient);
      EXPECT_NEAR(found.smallest_eigenvalue, -1., 1e-6);
      double trace = 0., norm_square = 0.;
      for (unsigned int i = 0; i < 3; ++i)
      {
        trace += found.direction[i][i];
        for (unsigned int j = 0; j < 3; ++j)
          norm_square += found.direction[i][j] * found.direction[i][j];
      }
      EXPECT_NEAR(trace, 1., 1e-9);
      EXPECT_LT(norm_square, 1. + 2e-6);
    }
}

TEST(Hex8Fluid, forces_of_the_pressure_do_the_work_of_the_volume)
{
  const Corners x = random_hexahedron(4), u = random_field(9, 1e-5);
  auto element = element_at_rest(x);
  const Corners forces =
    fluid_forces(gas, FluidViscosity{}, x, Corners{}, element);
  EXPECT_NEAR(element.pressure, 0.4 * 2.5 * 1.2, 1e-13);
  Corners ahead = x, behind = x;
  for (unsigned int i = 0; i < 8; ++i)
    for (unsigned int d = 0; d < 3; ++d)
    {
      ahead[i][d] += u[i][d];
      behind[i][d] -= u[i][d];
    }
  const double change = 0.5 * (hex_geometry(to_modes(ahead)).volume -
                               hex_geometry(to_modes(behind)).volume);
  EXPECT_NEAR(power(forces, u), -element.pressure * change, 1e-14);
  for (unsigned int d = 0; d < 3; ++d)
  {
    double sum = 0.;
    for (const auto &force : forces)
      sum += force[d];
    EXPECT_NEAR(sum, 0., 1e-14);
  }
}

// In a cube that is compressed along an edge the viscous pressure is
// rho (q_2 l^2 w^2 + q_1 l c w).
TEST(Hex8Fluid, viscosity_of_plane_compression_is_that_in_one_dimension)
{
  Corners x = random_hexahedron(1, 0.);
  for (auto &corner : x)
    corner[1] *= 3.;
  const double rate = 0.7;
  Matrix3<double> gradient{};
  gradient[1][1] = -rate;
  double viscosity;
  const FluidViscosity coefficients{0.3, 1.5, 0.};
  const auto stress =
    viscous_stress(coefficients, to_modes(x), gradient, 2., 5., viscosity);
  EXPECT_NEAR(
    -stress[1][1], 2. * (1.5 * 9. * rate * rate + 0.3 * 3. * 5. * rate), 1e-9);
  EXPECT_NEAR(stress[0][0], 0., 1e-12);
}

TEST(Hex8Fluid, viscosity_takes_energy_and_resists_compression_alone)
{
  const Corners x = random_hexahedron(2);
  for (unsigned int seed = 10; seed < 60; ++seed)
  {
    const Corners v = random_field(seed, 1.);
    auto element = element_at_rest(x);
    const double all =
      power(fluid_forces(gas, FluidViscosity{}, x, v, element), v);
    const double pressure_alone =
      power(fluid_forces(gas, FluidViscosity{0., 0., 0.}, x, v, element), v);
    EXPECT_GT(all, pressure_alone);
  }
  Matrix3<double> expansion{}, rotation{}, along_an_edge{};
  along_an_edge[0][0] = 0.3;
  for (unsigned int d = 0; d < 3; ++d)
    expansion[d][d] = 0.1 * (d + 1.);
  rotation[0][1] = 1.;
  rotation[1][0] = -1.;
  for (const auto &gradient : {expansion, rotation, along_an_edge})
  {
    auto element = element_at_rest(x);
    const Corners v = linear_field(x, gradient);
    const Corners with = fluid_forces(gas, FluidViscosity{}, x, v, element);
    const Corners without =
      fluid_forces(gas, FluidViscosity{0., 0., 0.}, x, v, element);
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_NEAR(with[i][d], without[i][d], 1e-6);
  }
}

TEST(Hex8Fluid, damper_resists_hourglass_modes)
{
  const Corners x = random_hexahedron(3);
  Corners v{};
  for (unsigned int i = 0; i < 8; ++i)
    v[i][0] = (i == 0 || i == 2 || i == 5 || i == 7) ? 1. : -1.;
  auto element = element_at_rest(x);
  const double with =
    power(fluid_forces(gas, FluidViscosity{0., 0., 0.1}, x, v, element), v);
  const double without =
    power(fluid_forces(gas, FluidViscosity{0., 0., 0.}, x, v, element), v);
  EXPECT_GT(with - without, 0.05);
}

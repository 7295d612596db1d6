// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/element/hex8_full.h>

#include "hexahedra.h"
#include <gtest/gtest.h>

using namespace contrecoup;

namespace
{
HexModel<double> model()
{
  HexModel<double> m{};
  m.law.bulk = 3e6;
  m.law.twice_shear = 2. * 1e6;
  return m;
}

template <SolidKinematics kinematics>
Corners forces(const Corners &x, const Corners &u)
{
  HexState<double> state{};
  HexDissipation<double> dissipation;
  std::array<Symmetric3<double>, 8> relaxed{};
  return full_forces<kinematics, false>(
    model(), x, u, state, relaxed, dissipation);
}

template <SolidKinematics kinematics>
double energy(const Corners &x_corners, const Corners &u_corners)
{
  const Corners x = to_modes(x_corners), u = to_modes(u_corners);
  const auto g = hex_geometry(x);
  const auto h = mean_gradient(g, u);
  double sum =
    g.volume *
    stored_energy<kinematics>(
      volume_law(model().law), solid_strain<kinematics>(h, cofactor(h)), {});
  for (unsigned int i = 0; i < 8; ++i)
  {
    const HexPoint<double> point = hex_point(x, u, i);
    sum +=
      point.volume * stored_energy<kinematics>(
                       shear_law(model().law),
                       solid_strain<kinematics>(point.h, cofactor(point.h)),
                       {});
  }
  return sum;
}

template <SolidKinematics kinematics>
void check_derivative(const unsigned int seed)
{
  const Corners x = random_hexahedron(seed, 0.15),
                u = random_field(seed + 100, 0.05);
  const Corners force = forces<kinematics>(x, u);
  for (unsigned int c = 0; c < 8; ++c)
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double step = 1e-5;
      Corners up = u, down = u;
      up[c][d] += step;
      down[c][d] -= step;
      const double slope =
        (energy<kinematics>(x, up) - energy<kinematics>(x, down)) / (2. * step);
      EXPECT_NEAR(force[c][d], slope, 1e-2 + 1e-7 * std::abs(slope));
    }
}
} // namespace


TEST(Hex8Full, PointsHoldTheVolumeAndTheMeanGradient)
{
  const Corners x = to_modes(random_hexahedron(1, 0.15)),
                u = to_modes(random_field(2, 0.1));
  const auto g = hex_geometry(x);
  const auto mean = mean_gradient(g, u);
  double volume = 0.;
  Matrix3<double> sum{};
  for (unsigned int i = 0; i < 8; ++i)
  {
    const HexPoint<double> point = hex_point(x, u, i);
    EXPECT_NEAR(point.volume, jacobian(x, point.place), 1e-15);
    volume += point.volume;
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        sum[a][b] += point.volume * point.h[a][b];
  }
  EXPECT_NEAR(volume, g.volume, 1e-14);
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b < 3; ++b)
      EXPECT_NEAR(sum[a][b] / volume, mean[a][b], 1e-14);
}


TEST(Hex8Full, ForcesDeriveFromTheEnergy)
{
  for (unsigned int seed = 0; seed < 5; ++seed)
  {
    check_derivative<SolidKinematics::small_strain>(seed);
    check_derivative<SolidKinematics::finite_rotation>(seed);
    check_derivative<SolidKinematics::neo_hookean>(seed);
  }
}


TEST(Hex8Full, LinearFieldsHaveTheForcesOfOnePoint)
{
  const Corners x = random_hexahedron(3, 0.15);
  Corners u;
  for (unsigned int c = 0; c < 8; ++c)
    for (unsigned int d = 0; d < 3; ++d)
      u[c][d] = 0.01 * x[c][d] + 0.02 * x[c][(d + 1) % 3];
  HexModel<double> one = model();
  HexState<double> state{};
  HexDissipation<double> dissipation;
  const Corners expected =
    one_point_forces<SolidKinematics::finite_rotation, false>(
      one, x, u, [&]() { return u; }, state, dissipation);
  const Corners found = forces<SolidKinematics::finite_rotation>(x, u);
  for (unsigned int c = 0; c < 8; ++c)
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(found[c][d], expected[c][d], 1e-8);
}


TEST(Hex8Full, RigidTurnsHaveNoForces)
{
  const Corners x = random_hexahedron(4, 0.15);
  const double c = std::cos(1.), s = std::sin(1.);
  Corners u;
  for (unsigned int i = 0; i < 8; ++i)
    u[i] = {{(c - 1.) * x[i][0] - s * x[i][1] + 3.,
             s * x[i][0] + (c - 1.) * x[i][1],
             1.}};
  for (const auto &force : forces<SolidKinematics::finite_rotation>(x, u))
    for (const double component : force)
      EXPECT_NEAR(component, 0., 1e-8);
}


TEST(Hex8Full, HourglassModesAreResisted)
{
  // A cube in the mode eta zeta of u_x has mean squares 1/3 of its shears.
  Corners u{};
  const Corners x = unit_cube();
  for (unsigned int c = 0; c < 8; ++c)
    u[c][0] = 0.01 * (2. * x[c][1] - 1.) * (2. * x[c][2] - 1.);
  // Amplitude a: gamma = 2 a zeta and 2 a eta, energy G / 2 * 2 * (2 a)^2 / 3.
  EXPECT_NEAR(
    energy<SolidKinematics::small_strain>(x, u), 1e6 * 4. * 1e-4 / 3., 1e-8);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/element/hex8_one_point.h>

#include "hexahedra.h"
#include <gtest/gtest.h>

using namespace contrecoup;

namespace
{
HexModel<double> model(const HourglassKind kind)
{
  HexModel<double> m{};
  m.law.bulk = 3e6;
  m.law.twice_shear = 2. * 1e6;
  m.hourglass.kind = kind;
  m.hourglass.stiffness =
    kind == HourglassKind::stiffness ? hourglass_spring * 1e6 : 1e6;
  m.hourglass.viscosity = 10.;
  m.step = 1e-6;
  return m;
}

template <SolidKinematics kinematics>
Corners
forces(const HexModel<double> &model, const Corners &x, const Corners &u)
{
  HexState<double> state{};
  HexDissipation<double> dissipation;
  return one_point_forces<kinematics, false>(
    model, x, u, [&]() { return u; }, state, dissipation);
}

/// Energy of strains and springs.
template <SolidKinematics kinematics>
double energy(const HexModel<double> &model,
              const Corners &x_corners,
              const Corners &u)
{
  const Corners x = to_modes(x_corners), modes = to_modes(u);
  const auto g = hex_geometry(x);
  const auto h = mean_gradient(g, modes);
  const auto strain = solid_strain<kinematics>(h, cofactor(h));
  double result = g.volume * stored_energy<kinematics>(model.law, strain, {});
  const auto q = hourglass_modes(g, modes, h);
  if (model.hourglass.kind == HourglassKind::stiffness)
    return result +
           half_work(
             spring_forces(model.hourglass.stiffness * g.stiffness_length(), q),
             q);
  double hourglass = 0.;
  Matrix3<double> unused{};
  assumed_strain_forces(model.hourglass.stiffness,
                        hex_frame(x),
                        g,
                        q,
                        kinematics == SolidKinematics::small_strain ? nullptr
                                                                    : &h,
                        unused,
                        hourglass);
  return result + hourglass;
}

/// A turn by a large angle about a skew axis.
Corners turned(const Corners &x)
{
  const double c = std::cos(2.1), s = std::sin(2.1);
  const double n[3] = {2. / 3., -1. / 3., 2. / 3.};
  Corners y = x;
  for (unsigned int k = 0; k < 8; ++k)
  {
    const Vector3<double> axis{{n[0], n[1], n[2]}};
    const Vector3<double> around = cross(axis, x[k]);
    const double along = dot(axis, x[k]);
    for (unsigned int d = 0; d < 3; ++d)
      y[k][d] = c * x[k][d] + s * around[d] + (1. - c) * along * n[d] + 5. + d;
  }
  return y;
}

Corners difference(Corners a, const Corners &b)
{
  for (unsigned int c = 0; c < 8; ++c)
    for (unsigned int d = 0; d < 3; ++d)
      a[c][d] -= b[c][d];
  return a;
}
} // namespace


TEST(Hex8, ModesAndTheirTransposeBelongTogether)
{
  const Corners x = random_hexahedron(1), f = random_hexahedron(2);
  const Corners modes = to_modes(x), back = to_corners(f);
  double a = 0., b = 0.;
  for (unsigned int m = 1; m < 8; ++m)
    a += dot(modes[m], f[m]);
  for (unsigned int c = 0; c < 8; ++c)
    b += dot(x[c], back[c]);
  EXPECT_NEAR(a, b, 1e-13);
}


TEST(Hex8, VolumeIsExactAndItsGradientItsDerivative)
{
  const Corners x = random_hexahedron(3);
  const auto g = hex_geometry(to_modes(x));
  // Two Gauss points a direction are exact for the Jacobian.
  double volume = 0.;
  for (unsigned int i = 0; i < 8; ++i)
  {
    const double p = std::sqrt(1. / 3.);
    volume += jacobian(
      to_modes(x),
      Vector3<double>{{i & 1 ? p : -p, i & 2 ? p : -p, i & 4 ? p : -p}});
  }
  EXPECT_NEAR(g.volume, volume, 1e-14);

  // The gradient of the volume is that of forces of a unit pressure.
  Corners modes{};
  for (unsigned int m = 0; m < 6; ++m)
    modes[m + 1] = g.volume_gradient[m];
  const Corners gradient = to_corners(modes);
  for (unsigned int c = 0; c < 8; ++c)
    for (unsigned int d = 0; d < 3; ++d)
    {
      Corners up = x, down = x;
      up[c][d] += 1e-4;
      down[c][d] -= 1e-4;
      const double slope = (hex_geometry(to_modes(up)).volume -
                            hex_geometry(to_modes(down)).volume) /
                           2e-4;
      EXPECT_NEAR(gradient[c][d], slope, 1e-11);
    }
}


TEST(Hex8, LinearFieldsHaveTheirGradientAndNoHourglassModes)
{
  const Corners x = random_hexahedron(4);
  const double a[3][3] = {{1., 2., 3.}, {-4., 5., 6.}, {7., -8., 9.}};
  Corners u;
  for (unsigned int c = 0; c < 8; ++c)
    for (unsigned int i = 0; i < 3; ++i)
      u[c][i] = 0.3 + a[i][0] * x[c][0] + a[i][1] * x[c][1] + a[i][2] * x[c][2];
  const auto g = hex_geometry(to_modes(x));
  const auto h = mean_gradient(g, to_modes(u));
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      EXPECT_NEAR(h[i][j], a[i][j], 1e-13);
  for (const auto &q : hourglass_modes(g, to_modes(u), h))
    for (const double component : q)
      EXPECT_NEAR(component, 0., 1e-12);
}


TEST(Hex8, RigidMotionHasNoForces)
{
  const Corners x = random_hexahedron(5);
  const Corners u = difference(turned(x), x);
  for (const auto kind : {HourglassKind::stiffness,
                          HourglassKind::assumed_strain,
                          HourglassKind::viscous})
    for (const Corners &f :
         {forces<SolidKinematics::finite_rotation>(model(kind), x, u),
          forces<SolidKinematics::neo_hookean>(model(kind), x, u)})
      for (const auto &corner : f)
        for (const double component : corner)
          EXPECT_NEAR(component, 0., 1e-8) << "of a stiffness of 1e6";
}


template <SolidKinematics kinematics>
void expect_forces_derive_from_energy(const double amplitude)
{
  const Corners x = random_hexahedron(6), u = random_field(7, amplitude);
  for (const auto kind :
       {HourglassKind::stiffness, HourglassKind::assumed_strain})
  {
    const Corners f = forces<kinematics>(model(kind), x, u);
    for (unsigned int c = 0; c < 8; ++c)
      for (unsigned int d = 0; d < 3; ++d)
      {
        Corners up = u, down = u;
        up[c][d] += 1e-5;
        down[c][d] -= 1e-5;
        const double slope = (energy<kinematics>(model(kind), x, up) -
                              energy<kinematics>(model(kind), x, down)) /
                             2e-5;
        EXPECT_NEAR(f[c][d], slope, 1e-3) << "of forces of 1e5";
      }
  }
}

TEST(Hex8, ForcesDeriveFromTheEnergy)
{
  expect_forces_derive_from_energy<SolidKinematics::small_strain>(0.1);
  expect_forces_derive_from_energy<SolidKinematics::finite_rotation>(0.1);
  expect_forces_derive_from_energy<SolidKinematics::neo_hookean>(0.1);
}


TEST(Hex8, StrainsThatTurnWithTheBodyHaveForcesThatTurn)
{
  const Corners x = random_hexahedron(8), u = random_field(9, 0.05);
  Corners y = x;
  for (unsigned int c = 0; c < 8; ++c)
    for (unsigned int d = 0; d < 3; ++d)
      y[c][d] += u[c][d];
  const auto m = model(HourglassKind::assumed_strain);
  const Corners f = forces<SolidKinematics::finite_rotation>(m, x, u);
  const Corners g =
    forces<SolidKinematics::finite_rotation>(m, x, difference(turned(y), x));
  // The shift that turned() adds to every corner is subtracted.
  const Corners expected = turned(f);
  Corners zero{};
  const Corners shift = turned(zero);
  for (unsigned int c = 0; c < 8; ++c)
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(g[c][d], expected[c][d] - shift[c][d], 1e-7);
}


TEST(Hex8, BrickBendsWithTheStiffnessOfItsMaterial)
{
  // u_x = k x y, u_y = - k x^2 / 2: a moment of k E I for an incompressible
  // material, where E = 3 G.
  const double hx = 0.7, hy = 0.4, hz = 0.3, shear = 1e6, k = 1e-3;
  std::array<Vector3<double>, 4> q{};
  q[2][0] = 8. * k * hx * hy;
  const auto f = brick_forces(shear, Vector3<double>{{hx, hy, hz}}, q);
  const double moment_of_area = 2. * hz * std::pow(2. * hy, 3) / 12.;
  const double exact = 0.5 * 3. * shear * moment_of_area * k * k * 2. * hx;
  EXPECT_NEAR(half_work(f, q), exact, 1e-12 * exact);
}


TEST(Hex8, LanesDoWhatNumbersDo)
{
  using Lane = Lanes<double>;
  constexpr unsigned int n = n_lanes<double>;
  HexVectors<Lane> x, u;
  std::array<Corners, n> xs, us;
  for (unsigned int lane = 0; lane < n; ++lane)
  {
    xs[lane] = random_hexahedron(10 + lane);
    us[lane] = random_field(30 + lane, 0.01);
    for (unsigned int c = 0; c < 8; ++c)
      for (unsigned int d = 0; d < 3; ++d)
      {
        x[c][d][lane] = xs[lane][c][d];
        u[c][d][lane] = us[lane][c][d];
      }
  }
  HexModel<Lane> m{};
  m.law.bulk = 3e6;
  m.law.twice_shear = 2e6;
  m.hourglass.stiffness = hourglass_spring * 1e6;
  HexState<Lane> state{};
  HexDissipation<Lane> dissipation;
  const auto f = one_point_forces<SolidKinematics::finite_rotation, false>(
    m, x, u, [&]() { return u; }, state, dissipation);
  for (unsigned int lane = 0; lane < n; ++lane)
  {
    const Corners one = forces<SolidKinematics::finite_rotation>(
      model(HourglassKind::stiffness), xs[lane], us[lane]);
    for (unsigned int c = 0; c < 8; ++c)
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_NEAR(f[c][d][lane], one[c][d], 1e-7);
  }
}


TEST(BulkViscosity, PushesInCompressionOnly)
{
  const BulkViscosity<double> viscosity{2., 3., 10.};
  EXPECT_EQ(viscosity.pressure(0.1, 0.5), 0.);
  // Speed 0.5 * 10 * 0.1 = 0.5 m/s: 2 * 0.5 + 3 * 0.25.
  EXPECT_NEAR(viscosity.pressure(-0.1, 0.5), 1.75, 1e-14);
}


TEST(Hourglass, UnknownWordNamesTheKnownOnes)
{
  EXPECT_EQ(find_choice(hourglass_controls, "assumed strain", "control"),
            HourglassKind::assumed_strain);
  EXPECT_THROW(find_choice(hourglass_controls, "stiffnes", "control"),
               InputError);
}

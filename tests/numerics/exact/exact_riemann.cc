// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/materials/explosives.h>
#include <contrecoup/numerics/exact/exact_riemann.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace contrecoup;

namespace
{
const GasMaterial &air()
{
  static const GasMaterial gas{IdealGas(1.4)};
  return gas;
}

/// Constants of the problem of Lee, those of LX-17 [Mbar, g/cm^3].
MieGrueneisen unreacted_explosive()
{
  JwlParameters jwl;
  jwl.A = 632.1;
  jwl.B = -0.04472;
  jwl.R1 = 11.3;
  jwl.R2 = 1.13;
  jwl.omega = 0.8938;
  jwl.reference_density = 1.905;
  return MieGrueneisen::jwl(jwl);
}

/// Half a unit in the last of @p digits significant digits.
double last_digit(const double value, const int digits)
{
  return 0.5 *
         std::pow(10., std::floor(std::log10(std::abs(value))) + 1. - digits);
}

void expect_star(const ExactRiemann &solution,
                 const double pressure,
                 const double velocity,
                 const double left_density,
                 const double right_density,
                 const int digits)
{
  EXPECT_FALSE(solution.has_vacuum());
  EXPECT_NEAR(
    solution.star_pressure(), pressure, 1.01 * last_digit(pressure, digits));
  EXPECT_NEAR(
    solution.star_velocity(), velocity, 1.01 * last_digit(velocity, digits));
  EXPECT_NEAR(solution.left_star_density(),
              left_density,
              1.01 * last_digit(left_density, digits));
  EXPECT_NEAR(solution.right_star_density(),
              right_density,
              1.01 * last_digit(right_density, digits));
}

/// Mass, momentum and energy carried through a front of speed @p speed by the
/// gas in @p state; equal on both sides of a shock.
std::array<double, 3> fluxes_through(const RiemannState &state,
                                     const GasMaterial &gas,
                                     const double speed)
{
  const double w = state.velocity - speed;
  const double energy =
    gas.internal_energy_density(state.density, state.pressure, state.products);
  return {{state.density * w,
           state.density * w * w + state.pressure,
           w * (energy + 0.5 * state.density * w * w + state.pressure)}};
}
} // namespace


// E. F. Toro, Riemann Solvers and Numerical Methods (2009), table 4.2 and
// 4.3; Sod's speeds likewise.
TEST(ExactRiemann, SolvesSodAndToro)
{
  const ExactRiemann sod({1., 0., 1.}, {0.125, 0., 0.1}, air());
  expect_star(sod, 0.30313, 0.92745, 0.42632, 0.26557, 5);
  EXPECT_NEAR(sod.right_head_speed(), 1.75216, 6e-6);

  const ExactRiemann toro_1({1., 0.75, 1.}, {0.125, 0., 0.1}, air());
  expect_star(toro_1, 0.466294, 1.36091, 0.579867, 0.339700, 6);

  const ExactRiemann toro_2({1., -2., 0.4}, {1., 2., 0.4}, air());
  EXPECT_NEAR(toro_2.star_pressure(), 0.00189387, 6e-9);
  EXPECT_NEAR(toro_2.star_velocity(), 0., 1e-14);
  EXPECT_NEAR(toro_2.left_star_density(), 0.0218521, 6e-8);

  const ExactRiemann toro_3({1., 0., 1000.}, {1., 0., 0.01}, air());
  expect_star(toro_3, 460.894, 19.5975, 0.575062, 5.99924, 6);
  EXPECT_NEAR(toro_3.right_head_speed(), 23.5175, 6e-5);

  const ExactRiemann toro_4(
    {5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.095}, air());
  expect_star(toro_4, 1691.65, 8.68977, 14.2823, 31.0426, 6);

  const ExactRiemann toro_5(
    {1., -19.59745, 1000.}, {1., -19.59745, 0.01}, air());
  EXPECT_NEAR(toro_5.star_pressure(), 460.894, 6e-4);
  EXPECT_NEAR(toro_5.star_velocity(), 1.4e-6, 6e-8);
}


TEST(ExactRiemann, SolvesLeBlanc)
{
  const GasMaterial gas{IdealGas(5. / 3.)};
  const ExactRiemann solution(
    {1., 0., 2. / 30.}, {1e-3, 0., 2. / 3. * 1e-10}, gas);
  expect_star(solution, 5.15578e-4, 0.621839, 0.0540793, 0.004, 6);
  EXPECT_NEAR(3. + 6. * solution.star_velocity(), 6.731, 6e-4);
  EXPECT_NEAR(3. + 6. * solution.right_head_speed(), 7.975, 6e-4);
}


// Independent values: isentrope p = p_c + K rho^(1 + omega) in closed form and
// quadrature of c/rho with 30 digits. LANL's ExactPack (2025) agrees to 1e-7.
TEST(ExactRiemann, SolvesShyuesJwlProblem)
{
  JwlParameters jwl;
  jwl.A = 8.545;
  jwl.B = 0.205;
  jwl.R1 = 4.6;
  jwl.R2 = 1.35;
  jwl.omega = 0.25;
  jwl.reference_density = 1.84;
  const GasMaterial gas{MieGrueneisen::jwl(jwl)};
  const ExactRiemann solution({1.7, 0., 10.}, {1., 0., 0.5}, gas);
  EXPECT_NEAR(solution.star_pressure(), 4.40710130391262911747, 1e-12);
  EXPECT_NEAR(solution.star_velocity(), 1.69523647257345330502, 1e-12);
  EXPECT_NEAR(solution.left_star_density(), 0.88807649452485795354, 1e-12);
  EXPECT_NEAR(solution.right_star_density(), 3.78128067925105523987, 1e-11);

  EXPECT_NEAR(solution.star_pressure(), 4.407101735576622, 1e-6);
  EXPECT_NEAR(solution.right_head_speed(), 2.3047531503, 1e-6);
  EXPECT_NEAR(solution.left_tail_speed(), -0.80090464, 1e-6);
  EXPECT_NEAR(solution.left_head_speed(), -2.73639164, 1e-8);
}


// The problem of Lee in LANL's ExactPack (riemann_jwl), in Mbar, g/cm^3 and cm:
// the right state is below the cold curve. Independent values as for Shyue's
// problem; ExactPack agrees to 8e-7.
TEST(ExactRiemann, SolvesLeesJwlProblemBelowTheColdCurve)
{
  const GasMaterial gas{unreacted_explosive()};
  EXPECT_LT(gas.internal_energy_density(3.81, 2., 0.),
            unreacted_explosive().cold_energy_density(3.81, 0.));
  const ExactRiemann solution({0.9525, 0., 1.}, {3.81, 0., 2.}, gas);
  EXPECT_NEAR(solution.star_pressure(), 1.19116346153530615808, 1e-12);
  EXPECT_NEAR(solution.star_velocity(), -0.13299598804322943447, 1e-12);
  EXPECT_NEAR(solution.left_star_density(), 1.04455990686713007545, 1e-12);
  EXPECT_NEAR(solution.right_star_density(), 3.51566382660948166898, 1e-12);
  const double speed = std::sqrt(gas.sound_speed_squared(
    solution.right_star_density(), solution.star_pressure(), 0.));
  EXPECT_NEAR(speed, 1.52221266313980361669, 1e-12);

  EXPECT_NEAR(solution.star_pressure(), 1.1911644, 1e-6);
  EXPECT_NEAR(solution.star_velocity(), -0.13299659, 1e-6);
  EXPECT_NEAR(solution.left_star_density(), 1.0445603, 1e-6);
  EXPECT_NEAR(solution.right_star_density(), 3.5156642, 1e-6);
  EXPECT_NEAR(speed, 1.5222130, 1e-6);
}


// Where matter below the cold curve expands, its sound speed is not real in the
// end.
TEST(ExactRiemann, RefusesToExpandToAnImaginarySoundSpeed)
{
  const GasMaterial gas{unreacted_explosive()};
  EXPECT_THROW(ExactRiemann({3.81, -2., 2.}, {3.81, 2., 2.}, gas),
               NumericsError);
}


// Burned TNT (1630 kg/m^3 with all of its energy) next to air at rest.
TEST(ExactRiemann, SolvesProductsBesideAir)
{
  const JwlParameters jwl = find_explosive("tnt").jwl;
  const GasMaterial products{MieGrueneisen::jwl(jwl)};
  const GasMaterial mixture{MieGrueneisen::jwl_in_air(jwl)};
  const double pressure = products.pressure(1630., 6e9, 1.);
  const RiemannState burned{1630., 0., pressure, 1.};
  const RiemannState ambient{1.225, 0., 101325., 0.};

  const ExactRiemann two_gases(burned, products, ambient, air());
  EXPECT_NEAR(two_gases.star_pressure(), 23.517e6, 600.);
  EXPECT_NEAR(two_gases.star_velocity(), 3981.1, 0.06);
  EXPECT_NEAR(two_gases.left_star_density(), 100.55, 0.006);
  EXPECT_NEAR(two_gases.right_star_density(), 7.170, 6e-4);
  EXPECT_NEAR(two_gases.right_head_speed(), 4801., 0.6);

  const ExactRiemann one_mixture(burned, ambient, mixture);
  EXPECT_NEAR(
    one_mixture.star_pressure() / two_gases.star_pressure(), 1., 1e-12);
  EXPECT_EQ(one_mixture.value(3900.).products, 1.);
  EXPECT_EQ(one_mixture.value(4000.).products, 0.);

  const ExactRiemann same_gas(burned, ambient, products);
  EXPECT_NEAR(same_gas.star_pressure(), 23.113e6, 600.);
  EXPECT_NEAR(same_gas.star_velocity(), 3988.3, 0.06);
  EXPECT_NEAR(same_gas.right_head_speed(), 4710., 0.6);

  // The mirrored problem.
  const ExactRiemann mirrored(ambient, air(), burned, products);
  EXPECT_NEAR(mirrored.star_velocity(), -two_gases.star_velocity(), 1e-9);
  EXPECT_NEAR(mirrored.left_head_speed(), -two_gases.right_head_speed(), 1e-9);
}


TEST(ExactRiemann, SatisfiesTheJumpConditionsAtShocks)
{
  const GasMaterial water{MieGrueneisen::stiffened_gas(4.4, 6e8)};
  const GasMaterial products{MieGrueneisen::jwl(find_explosive("c-4").jwl)};
  const RiemannState slow{1200., -300., 1e9, 1.}, fast{900., 2500., 4e9, 1.};
  for (const GasMaterial &gas : {water, products, air()})
  {
    const ExactRiemann solution(fast, slow, gas);
    ASSERT_GT(solution.star_pressure(), fast.pressure);
    const RiemannState star_left{solution.left_star_density(),
                                 solution.star_velocity(),
                                 solution.star_pressure(),
                                 1.};
    const RiemannState star_right{solution.right_star_density(),
                                  solution.star_velocity(),
                                  solution.star_pressure(),
                                  1.};
    const auto left = fluxes_through(fast, gas, solution.left_head_speed());
    const auto left_star =
      fluxes_through(star_left, gas, solution.left_head_speed());
    const auto right = fluxes_through(slow, gas, solution.right_head_speed());
    const auto right_star =
      fluxes_through(star_right, gas, solution.right_head_speed());
    for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(left[i] / left_star[i], 1., 1e-12);
      EXPECT_NEAR(right[i] / right_star[i], 1., 1e-12);
    }
  }
}


// Inside a rarefaction of an ideal gas everything has a closed form.
TEST(ExactRiemann, SamplesRarefactions)
{
  const ExactRiemann solution({1., -2., 0.4}, {1., 2., 0.4}, air());
  const double c = std::sqrt(1.4 * 0.4);
  for (const double speed : {-2.74, -2., -1., -0.4})
  {
    const RiemannState state = solution.value(speed);
    const double velocity = (2. / 2.4) * (c - 0.2 * 2. + speed);
    EXPECT_NEAR(state.velocity, velocity, 1e-13);
    const double ratio = (velocity - speed) / c;
    EXPECT_NEAR(state.density, std::pow(ratio, 5.), 1e-13);
    EXPECT_NEAR(state.pressure, 0.4 * std::pow(ratio, 7.), 1e-13);

    const RiemannState mirrored = solution.value(-speed);
    EXPECT_NEAR(mirrored.velocity, -velocity, 1e-13);
    EXPECT_NEAR(mirrored.density, state.density, 1e-14);
  }
  EXPECT_EQ(solution.value(-2.75).velocity, -2.);
  EXPECT_EQ(solution.value(2.75).density, 1.);
  EXPECT_EQ(solution.value(0.1).pressure, solution.star_pressure());
}


TEST(ExactRiemann, FindsTheVacuumBetweenRecedingGases)
{
  const double escape = 5. * std::sqrt(1.4 * 0.4); // 3.742
  for (const double speed : {3.742, 3.75, 5., 100.})
  {
    const ExactRiemann solution({1., -speed, 0.4}, {1., speed, 0.4}, air());
    ASSERT_TRUE(solution.has_vacuum());
    EXPECT_NEAR(solution.left_tail_speed(), escape - speed, 1e-11);
    EXPECT_NEAR(solution.right_tail_speed(), speed - escape, 1e-11);
    EXPECT_EQ(solution.value(0.).density, 0.);
    const RiemannState state = solution.value(-speed);
    EXPECT_NEAR(state.density, std::pow(1. / 1.2, 5.), 1e-12);
    const RiemannState thin = solution.value(solution.left_tail_speed() - 1e-3);
    EXPECT_GT(thin.density, 0.);
    EXPECT_LT(thin.density, 1e-14);
  }
  const ExactRiemann close({1., -3.741, 0.4}, {1., 3.741, 0.4}, air());
  EXPECT_FALSE(close.has_vacuum());
  EXPECT_GT(close.star_pressure(), 0.);
}


TEST(ExactRiemann, LeavesAUniformGasAsItIs)
{
  const RiemannState state{1.2, 30., 1e5, 0.};
  const ExactRiemann solution(state, state, air());
  EXPECT_EQ(solution.star_pressure(), 1e5);
  EXPECT_EQ(solution.star_velocity(), 30.);
  EXPECT_EQ(solution.value(0.).density, 1.2);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/materials/johnson_cook.h>

#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;

namespace
{
constexpr double copper_shear = 46.3e9;

/// Von Mises' equivalent stress of a deviator.
double equivalent(const Symmetric3<double> &deviator)
{
  return std::sqrt(1.5 * contract(deviator, deviator));
}

Matrix3<double> full(const Symmetric3<double> &s)
{
  return {{{{s[0], s[3], s[5]}}, {{s[3], s[1], s[4]}}, {{s[5], s[4], s[2]}}}};
}

Matrix3<double> times(const Matrix3<double> &a, const Matrix3<double> &b)
{
  Matrix3<double> c{};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int k = 0; k < 3; ++k)
        c[i][j] += a[i][k] * b[k][j];
  return c;
}

Matrix3<double> transposed(const Matrix3<double> &a)
{
  Matrix3<double> result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      result[i][j] = a[j][i];
  return result;
}

/// det(1 + e) - 1.
double excess_of_determinant(const Symmetric3<double> &e)
{
  const auto h = full(e);
  return finite_dilatation(h, cofactor(h));
}

/// The displacement gradient of a turn about an axis by an angle.
Matrix3<double> turn(const unsigned int axis, const double angle)
{
  Matrix3<double> result{};
  const unsigned int i = (axis + 1) % 3, j = (axis + 2) % 3;
  result[i][i] = result[j][j] = std::cos(angle) - 1.;
  result[j][i] = std::sin(angle);
  result[i][j] = -result[j][i];
  return result;
}

/// Random displacement gradients.
Matrix3<double> shake(std::mt19937 &random, const double size)
{
  std::uniform_real_distribution<double> number(-size, size);
  Matrix3<double> result;
  for (auto &row : result)
    for (double &component : row)
      component = number(random);
  return result;
}

/// Displacement gradient of one step that stretches x and keeps the volume.
Matrix3<double> isochoric_stretch(const double logarithm)
{
  Matrix3<double> result{};
  result[0][0] = std::expm1(logarithm);
  result[1][1] = result[2][2] = std::expm1(-0.5 * logarithm);
  return result;
}

/// Stress of a bar that is pulled, or pushed, to a logarithmic strain.
double pulled_stress(const JohnsonCook &law,
                     const double strain,
                     const double rate,
                     const unsigned int n_steps,
                     MetalState<double> &state)
{
  Symmetric3<double> deviator{};
  for (unsigned int i = 0; i < n_steps; ++i)
    deviator = strain_metal(law,
                            copper_shear,
                            isochoric_stretch(strain / n_steps),
                            std::abs(strain) / rate / n_steps,
                            state);
  return 1.5 * deviator[0];
}

/// The same by the classical method of Runge and Kutta for the plastic work
/// over the plastic strain, whose rate is taken to be that of the strain.
double expected_stress(const JohnsonCook &law,
                       const double plastic_strain,
                       const double rate)
{
  const auto slope = [&](const double strain, const double work) {
    const double warmed = law.heating_fraction * work / law.heat_capacity /
                          (law.melting_temperature - law.reference_temperature);
    return (law.yield_stress +
            law.hardening * std::pow(strain, law.hardening_exponent)) *
           (1. + law.rate_coefficient * std::log(rate / law.reference_rate)) *
           (1. - std::pow(warmed, law.softening_exponent));
  };
  constexpr unsigned int n = 2000;
  const double h = plastic_strain / n;
  double work = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double a = slope(i * h, work),
                 b = slope((i + 0.5) * h, work + 0.5 * h * a),
                 c = slope((i + 0.5) * h, work + 0.5 * h * b),
                 d = slope((i + 1.) * h, work + h * c);
    work += h / 6. * (a + 2. * b + 2. * c + d);
  }
  return slope(plastic_strain, work);
}
} // namespace


TEST(JohnsonCook, StrengthIsThatOfTheFormula)
{
  const JohnsonCook copper;
  EXPECT_EQ(copper.strength(0., 0., 0.), 90e6);
  EXPECT_NEAR(
    copper.strength(0.5, 1., 0.), 90e6 + 292e6 * std::pow(0.5, 0.31), 1e-3);
  EXPECT_NEAR(
    copper.strength(1., 1e4, 0.), 382e6 * (1. + 0.1 * std::log(10.)), 1e-3);
  // Slower than the reference rate, it is not weaker.
  EXPECT_EQ(copper.strength(1., 1e-3, 0.), 382e6);
  // Half way to the melt, and in it.
  const double half_way = 8960. * 383. * 529. / 0.9;
  EXPECT_NEAR(copper.temperature(half_way), 827., 1e-9);
  EXPECT_NEAR(copper.strength(1., 1., half_way),
              382e6 * (1. - std::pow(0.5, 1.09)),
              1e-3);
  EXPECT_EQ(copper.strength(1., 1., 3. * half_way), 0.);
}


TEST(JohnsonCook, RefusesToMeltBelowTheReference)
{
  JohnsonCook metal;
  metal.check("metal");
  metal.melting_temperature = 298.;
  EXPECT_THROW(metal.check("metal"), InputError);
}


// Equation of the step, for stresses from just above the strength to far above
// it, at rates on both sides of the reference, cold, warm and molten.
TEST(JohnsonCook, IncrementBringsTheStressToTheStrength)
{
  const JohnsonCook copper;
  for (const double strain : {0., 1e-9, 1e-3, 0.4, 3.})
    for (const double work : {0., 1e9, 1e10})
      for (const double step : {1e-9, 1e-6, 1., 1e6})
        for (const double over : {1.0001, 1.3, 10.})
        {
          const double still = copper.strength(strain, 0., work);
          const double stress = over * std::max(still, 1e6);
          const double added = copper.plastic_increment(
            stress, 3. * copper_shear, strain, work, step);
          EXPECT_GT(added, 0.);
          EXPECT_NEAR(stress - 3. * copper_shear * added,
                      copper.strength(strain + added, added / step, work),
                      1e-9 * stress);
          EXPECT_EQ(copper.plastic_increment(
                      still, 3. * copper_shear, strain, work, step),
                    0.);
        }
}


TEST(JohnsonCook, PulledAndPushedBarsFollowTheCurve)
{
  const JohnsonCook copper;
  for (const double sign : {1., -1.})
    for (const double rate : {10., 1e4})
      for (const double strain : {0.05, 0.3, 1.})
      {
        MetalState<double> state;
        const double stress =
          sign * pulled_stress(copper, sign * strain, rate, 1000, state);
        const double expected =
          expected_stress(copper, state.plastic_strain, rate);
        EXPECT_NEAR(stress, expected, 1e-3 * expected);
        // Strains are the elastic and the plastic one, to the part of the
        // elastic one by which the return of Simo differs from the flow.
        const double elastic = stress / (3. * copper_shear);
        EXPECT_NEAR(
          state.plastic_strain + elastic, strain, 1.2 * strain * elastic);
      }
}


TEST(JohnsonCook, WithoutYieldIsNeoHookean)
{
  JohnsonCook rubber;
  rubber.yield_stress = 1e15;
  std::mt19937 random(3);
  Matrix3<double> h{};
  MetalState<double> state;
  for (unsigned int i = 0; i < 50; ++i)
  {
    const auto increment = shake(random, 0.1);
    const auto product = times(increment, h);
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        h[a][b] += increment[a][b] + product[a][b];
    const auto deviator = strain_metal(rubber, 1., increment, 1e-6, state);
    const auto cofactors = cofactor(h);
    const auto strain =
      solid_strain<SolidKinematics::neo_hookean>(h, cofactors);
    Symmetric3<double> shear;
    for (unsigned int k = 0; k < 6; ++k)
      shear[k] = 2. * strain.shear_measure[k];
    const auto piola =
      piola_stress<SolidKinematics::neo_hookean>(h, cofactors, 0., shear);
    const auto kirchhoff = times(piola, transposed(h));
    SolidLaw<double> law{};
    law.bulk = law.twice_relaxing = 0.;
    law.twice_shear = 2.;
    for (unsigned int k = 0; k < 6; ++k)
    {
      const unsigned int a = k % 3, b = k < 3 ? a : (a + 1) % 3;
      ASSERT_NEAR(deviator[k], piola[a][b] + kirchhoff[a][b], 1e-9);
    }
    EXPECT_NEAR(metal_shear_energy(1., state.elastic),
                stored_energy<SolidKinematics::neo_hookean>(law, strain, {}),
                1e-9);
  }
  EXPECT_EQ(state.plastic_strain, 0.);
  EXPECT_EQ(state.plastic_work, 0.);
}


// A metal that is turned while it is strained has the stress that turned with
// it, and has flowed as much.
TEST(JohnsonCook, RotationsTurnTheStress)
{
  const JohnsonCook copper;
  std::mt19937 random(5);
  MetalState<double> still, turning;
  Matrix3<double> turned{};
  for (unsigned int i = 0; i < 3; ++i)
    turned[i][i] = 1.;
  for (unsigned int i = 0; i < 30; ++i)
  {
    auto f = shake(random, 0.01);
    for (unsigned int a = 0; a < 3; ++a)
      f[a][a] += 1.;
    auto by = turn(i % 3, 0.7);
    for (unsigned int a = 0; a < 3; ++a)
      by[a][a] += 1.;
    // Turned back, strained, and turned on.
    auto g = times(by, times(turned, times(f, transposed(turned))));
    turned = times(by, turned);
    for (unsigned int a = 0; a < 3; ++a)
    {
      f[a][a] -= 1.;
      g[a][a] -= 1.;
    }
    const auto expected =
      full(strain_metal(copper, copper_shear, f, 1e-6, still));
    const auto found =
      full(strain_metal(copper, copper_shear, g, 1e-6, turning));
    const auto rotated = times(turned, times(expected, transposed(turned)));
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        ASSERT_NEAR(found[a][b], rotated[a][b], 1.);
  }
  EXPECT_GT(still.plastic_strain, 0.1);
  EXPECT_NEAR(turning.plastic_strain, still.plastic_strain, 1e-12);
}


TEST(JohnsonCook, FlowKeepsTheVolumeAndLosesEnergy)
{
  const JohnsonCook copper;
  std::mt19937 random(11);
  MetalState<double> state;
  for (unsigned int i = 0; i < 2000; ++i)
  {
    const MetalState<double> before = state;
    const auto deviator =
      strain_metal(copper, copper_shear, shake(random, 0.02), 1e-7, state);
    EXPECT_NEAR(excess_of_determinant(state.elastic), 0., 1e-14);
    EXPECT_NEAR(deviator[0] + deviator[1] + deviator[2], 0., 1e-5);
    EXPECT_GE(state.plastic_strain, before.plastic_strain);
    // Backward Euler's work, that of the stress after the step.
    EXPECT_NEAR(state.plastic_work - before.plastic_work,
                equivalent(deviator) *
                  (state.plastic_strain - before.plastic_strain),
                1e-9 * state.plastic_work);
    EXPECT_GE(metal_shear_energy(copper_shear, state.elastic), 0.);
  }
  EXPECT_GT(state.plastic_strain, 10.);
  // It has become warm, and weak.
  EXPECT_GT(copper.temperature(state.plastic_work), 900.);
}


TEST(JohnsonCook, LanesAreWhatNumbersAre)
{
  using Lane = Lanes<double>;
  const JohnsonCook copper;
  std::mt19937 random(13);
  MetalState<Lane> lanes;
  std::array<MetalState<double>, n_lanes<double>> numbers;
  for (unsigned int i = 0; i < 20; ++i)
  {
    Matrix3<Lane> increment;
    for (unsigned int lane = 0; lane < n_lanes<double>; ++lane)
    {
      // Some yield and some do not.
      const auto one = shake(random, lane % 2 == 0 ? 1e-4 : 0.02);
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          increment[a][b][lane] = one[a][b];
    }
    const auto found =
      strain_metal(copper, copper_shear, increment, 1e-7, lanes);
    for (unsigned int lane = 0; lane < n_lanes<double>; ++lane)
    {
      Matrix3<double> one;
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          one[a][b] = increment[a][b][lane];
      const auto expected =
        strain_metal(copper, copper_shear, one, 1e-7, numbers[lane]);
      // The compiler may fuse operations differently.
      for (unsigned int k = 0; k < 6; ++k)
      {
        EXPECT_NEAR(found[k][lane], expected[k], 1e-3);
        EXPECT_NEAR(lanes.elastic[k][lane], numbers[lane].elastic[k], 1e-13);
      }
      EXPECT_NEAR(
        lanes.plastic_strain[lane], numbers[lane].plastic_strain, 1e-13);
    }
  }
  EXPECT_GT(numbers[1].plastic_strain, 0.1);
}

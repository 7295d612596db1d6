// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/materials/tait.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace contrecoup;

namespace
{
constexpr double rest_density = 1000., bulk_modulus = 2.2e9;

double pressure(const Tait &liquid, const double density)
{
  return liquid.pressure(density, 0., 0.);
}
} // namespace

// The classical mistake is B = K_0, which makes water seven times too stiff.
TEST(Tait, bulk_modulus_at_rest_is_that_given)
{
  const Tait water(rest_density, bulk_modulus);
  const double step = 1e-4;
  const double slope = (pressure(water, rest_density + step) -
                        pressure(water, rest_density - step)) /
                       (2. * step);
  EXPECT_NEAR(slope * rest_density, bulk_modulus, 1e-6 * bulk_modulus);
  double p, square;
  water.pressure_and_sound_speed(rest_density, 0., 0., p, square);
  EXPECT_NEAR(p, 0., 1e-6);
  EXPECT_NEAR(square * rest_density, bulk_modulus, 1e-6);
}

TEST(Tait, stored_energy_is_the_integral_of_the_pressure)
{
  const Tait water(rest_density, bulk_modulus, 7.15, -1e5);
  EXPECT_DOUBLE_EQ(water.stored_energy(rest_density), 0.);
  for (const double density : {600., 999.9, 999.99, 1010., 1200.})
  {
    const double step = 1e-6 * density;
    const double slope = (water.stored_energy(density + step) -
                          water.stored_energy(density - step)) /
                         (2. * step);
    const double expected = pressure(water, density) / (density * density);
    EXPECT_NEAR(slope, expected, 1e-5 * std::abs(expected) + 1e-7) << density;
  }
}

TEST(Tait, pressure_stays_at_its_least_in_cavitation)
{
  const Tait water(rest_density, bulk_modulus, 7.15, -1e5);
  EXPECT_NEAR(pressure(water, water.cavitation_density()), -1e5, 1e-6);
  EXPECT_EQ(pressure(water, 0.9 * rest_density), -1e5);
  EXPECT_GT(pressure(water, rest_density * (1. - 1e-5)), -1e5);
  EXPECT_NEAR(
    water.void_fraction(0.5 * water.cavitation_density()), 0.5, 1e-15);
  EXPECT_EQ(water.void_fraction(rest_density), 0.);
  EXPECT_NEAR(pressure(water, water.density_at(3e7)), 3e7, 1e-4);
  const Tait whole(rest_density, bulk_modulus);
  EXPECT_LT(pressure(whole, 0.9 * rest_density), -1.6e8);
}

TEST(Tait, lanes_agree_with_numbers)
{
  const Tait water(rest_density, bulk_modulus, 7.15, -1e5);
  std::vector<double> densities;
  for (double density = 400.; density < 2500.; density *= 1.013)
    densities.push_back(density);
  densities.insert(densities.end(), {999.99, 1000., 1000.0001, 1012.});
  for (const double density : densities)
  {
    Lanes<double> lanes(density), p, square;
    water.pressure_and_sound_speed(
      lanes, Lanes<double>(), Lanes<double>(), p, square);
    double expected_p, expected_square;
    water.pressure_and_sound_speed(
      density, 0., 0., expected_p, expected_square);
    EXPECT_NEAR(
      p[0], expected_p, 1e-13 * (bulk_modulus + std::abs(expected_p)));
    EXPECT_NEAR(square[0], expected_square, 1e-13 * expected_square);
  }
}

TEST(Tait, refuses_constants_without_meaning)
{
  EXPECT_THROW(Tait(0., 1.), InputError);
  EXPECT_THROW(Tait(1., -1.), InputError);
  EXPECT_THROW(Tait(1., 1., 1.), InputError);
  EXPECT_THROW(Tait(1., 1., 7., 1.), InputError);
  EXPECT_THROW(Tait(1000., 7., 7., -2.), InputError);
}

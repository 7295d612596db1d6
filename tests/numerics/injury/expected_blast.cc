// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/injury/expected_blast.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;

namespace
{
constexpr double pressure = 101325., density = 1.225;
const double sound_speed = std::sqrt(1.4 * pressure / density);
} // namespace

// Sedov's constant for gamma = 1.4 is 0.851 in E = 0.851 rho r^5 / t^2.
TEST(ExpectedBlast, IsSedovsNearAndSoundFarAway)
{
  const double energy = 4e6;
  const ExpectedBlast blast(energy, pressure, density);
  const double near = 1e-3;
  const double time =
    std::sqrt(0.851072 * density * std::pow(near, 5) / energy);
  EXPECT_NEAR(blast.arrival(near) / time, 1., 0.03);
  const double far = 1e4;
  EXPECT_NEAR(
    (blast.arrival(far + 1.) - blast.arrival(far)) * sound_speed, 1., 1e-6);
  EXPECT_LT(blast.overpressure(far), 1e-2 * pressure);
}

TEST(ExpectedBlast, IsContinuousAndInverts)
{
  const PointSourceSolution source(4e6, pressure, density);
  const ExpectedBlast blast(4e6, pressure, density);
  for (const double edge : {source.smallest_radius(), source.largest_radius()})
  {
    EXPECT_NEAR(blast.arrival(edge * (1. - 1e-9)) /
                  blast.arrival(edge * (1. + 1e-9)),
                1.,
                1e-6);
    EXPECT_NEAR(blast.overpressure(edge * (1. - 1e-9)) /
                  blast.overpressure(edge * (1. + 1e-9)),
                1.,
                1e-6);
  }
  for (const double distance : {0.01, 0.3, 2., 30., 1000.})
    EXPECT_NEAR(blast.radius(blast.arrival(distance)) / distance, 1., 1e-6);
  EXPECT_THROW(ExpectedBlast(0., pressure, density), InputError);
}

// Mach 2: the pressure rises 4.5-fold, the gas moves with 1.25 times the
// sound speed; a sound wave moves it by overpressure / (rho c).
TEST(ExpectedBlast, KnowsTheGasBehindAShock)
{
  EXPECT_NEAR(speed_behind_shock(3.5 * pressure, pressure, density) /
                sound_speed,
              1.25,
              1e-12);
  EXPECT_NEAR(speed_behind_shock(1., pressure, density) * density * sound_speed,
              1.,
              1e-4);
}

// At 3000 K vibrations hold (0.79 * 1646 + 0.21 * 2006) K of 9222 K in all, of
// which a perfect gas would make pressure.
TEST(ExpectedBlast, KnowsWhenAirVibrates)
{
  EXPECT_LT(excess_pressure_of_perfect_air(1e4, pressure, density), 1e-4);
  EXPECT_GT(excess_pressure_of_perfect_air(1e4, pressure, density), 0.);
  double before = 0.;
  for (const double ratio : {1., 10., 100., 1000.})
  {
    const double excess =
      excess_pressure_of_perfect_air(ratio * pressure, pressure, density);
    EXPECT_GT(excess, before);
    before = excess;
  }
  // The most that vibrations can take: a third of 7 / 2 degrees of freedom.
  EXPECT_LT(before, 0.4);
  // Perfect air of T' = T + (2 / 5) e_vibration(T) has the energy of air at T.
  const double t = 3000.;
  const double vibration =
    0.79 * 3390. / std::expm1(3390. / t) + 0.21 * 2270. / std::expm1(2270. / t);
  const double hot = t + 0.4 * vibration;
  // The shock that makes a perfect gas as hot as that.
  double low = 0., high = 1e3;
  const double ambient = pressure / (density * 287.05);
  while (high - low > 1e-10)
  {
    const double middle = 0.5 * (low + high), ratio = 1. + middle;
    (ambient * ratio * (6. + ratio) / (1. + 6. * ratio) < hot ? low : high) =
      middle;
  }
  EXPECT_NEAR(excess_pressure_of_perfect_air(low * pressure, pressure, density),
              hot / t - 1.,
              2e-4);
}

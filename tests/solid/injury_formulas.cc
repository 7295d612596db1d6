// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/injury_formulas.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup::solid;

TEST(Injury, HeadInjuryCriterionOfConstantAcceleration)
{
  // 100 g for 10 ms, then nothing.
  std::vector<double> times;
  std::vector<std::array<double, 3>> speeds;
  for (unsigned int i = 0; i <= 30; ++i)
  {
    times.push_back(1e-3 * i);
    speeds.push_back({{0., 980.665e-3 * std::min(i, 10U), 0.}});
  }
  EXPECT_NEAR(head_injury_criterion(times, speeds, 0.015), 1000., 1e-6);
  EXPECT_NEAR(head_injury_criterion(times, speeds, 0.005), 500., 1e-6);
}


TEST(Injury, ChestWallVelocityOfFriedlanderPulses)
{
  // Peak [kPa], duration [ms], velocity [m/s]: independent integration.
  const double expected[4][3] = {{100., 2., 1.922},
                                 {200., 2., 3.830},
                                 {200., 5., 6.020},
                                 {400., 5., 11.547}};
  for (const auto &[peak, duration, velocity] : expected)
  {
    const double p = 1e3 * peak, t = 1e-3 * duration;
    const auto pulse = [&](const double time) {
      return p * (1. - time / t) * std::exp(-time / t);
    };
    EXPECT_NEAR(chest_wall_velocity(pulse, 0.03), velocity, 2e-3);
  }
}


TEST(Injury, PublishedLimits)
{
  // Bowen's curve of half survival for 70 kg, kPa at ms.
  const double bowen[3][2] = {{1., 3290.}, {5., 941.}, {20., 542.}};
  for (const auto &[duration, pressure] : bowen)
    EXPECT_NEAR(
      half_lethal_overpressure(1e-3 * duration, 70.), 1e3 * pressure, 1e3);
  EXPECT_NEAR(eardrum_rupture(103e3), 0.5, 0.01);
  EXPECT_LT(eardrum_rupture(34.5e3), 0.06);
  EXPECT_EQ(eardrum_rupture(0.), 0.);
  EXPECT_NEAR(
    brain_injury_criterion({{66.25, 0., 42.87}}), std::sqrt(2.), 1e-12);
}


TEST(Injury, PercentileByVolume)
{
  EXPECT_EQ(volume_percentile({{3., 1.}, {1., 8.}, {2., 1.}}, 0.85), 2.);
  EXPECT_EQ(volume_percentile({{3., 1.}, {1., 8.}, {2., 1.}}, 0.5), 1.);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/injury/load_injury.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;

namespace
{
/// The load that tests/plot/tiny_scene.py gives to a place of the skin: a front
/// that decays, and a weaker one 1.5 ms later.
LoadInjury under_two_fronts(const double peak, const double body_mass)
{
  std::vector<double> times, pressures(241, 0.);
  for (unsigned int i = 0; i < pressures.size(); ++i)
  {
    times.push_back(6e-3 * i / 240.);
    for (const auto &[begin, size] : {std::pair(1.8e-3, 1.), {3.3e-3, 0.25}})
    {
      const double x = (times[i] - begin) / 1e-3;
      if (x > -1e-9)
        pressures[i] += peak * size * (1. - x) * std::exp(-x);
    }
  }
  return load_injury(times, pressures, body_mass);
}
} // namespace

// Integrated independently with steps of 1.25 microseconds.
TEST(LoadInjury, OfTwoFrontsIsKnown)
{
  const LoadInjury chest = under_two_fronts(9e5, 78.5);
  EXPECT_FALSE(chest.is_velocity_cut);
  EXPECT_FALSE(chest.pulse.is_cut);
  EXPECT_DOUBLE_EQ(chest.pulse.peak, 9e5);
  EXPECT_NEAR(chest.chest_wall_velocity, 10.8423, 1e-3);
  EXPECT_NEAR(chest.pulse.duration, 1e-3, 1e-12);
  EXPECT_NEAR(chest.lung_exposure, 0.2639789, 1e-6);
  EXPECT_NEAR(under_two_fronts(2e5, 78.5).chest_wall_velocity, 2.4220, 1e-3);
  EXPECT_NEAR(under_two_fronts(1.75e5, 78.5).eardrum_rupture, 0.7877251, 1e-6);
  // The lighter suffer more.
  EXPECT_GT(under_two_fronts(9e5, 20.).lung_exposure, chest.lung_exposure);
}

TEST(LoadInjury, CountsTheFirstPositivePhaseAlone)
{
  const std::vector<double> times{0., 1., 2., 3., 4., 5., 6.};
  const PressurePulse whole = first_pulse(times, {0., 0., 8., 4., 0., 6., 6.}),
                      cut = first_pulse(times, {0., -1., .1, 8., 4., 6., 6.}),
                      never =
                        first_pulse(times, {0., -1., -1., 0., 0., 0., 0.});
  EXPECT_EQ(whole.peak, 8.);
  EXPECT_EQ(whole.duration, 2.);
  EXPECT_FALSE(whole.is_cut);
  EXPECT_EQ(cut.duration, 3.);
  EXPECT_TRUE(cut.is_cut);
  EXPECT_EQ(never.duration, 0.);
  const LoadInjury none = load_injury(times, std::vector<double>(7, 0.), 70.);
  EXPECT_EQ(none.lung_exposure, 0.);
  EXPECT_EQ(none.eardrum_rupture, 0.);
  EXPECT_EQ(none.chest_wall_velocity, 0.);
  // Nothing has arrived so far.
  EXPECT_TRUE(none.is_velocity_cut);
}

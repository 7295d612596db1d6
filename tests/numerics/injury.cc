// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/injury/blast_injury.h>
#include <contrecoup/numerics/injury/chest_wall.h>
#include <contrecoup/numerics/injury/head_injury.h>
#include <contrecoup/numerics/injury/load_injury.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;

namespace
{
const double ambient = 101325.;
const double psi = 6894.757; // Pa

/// Friedlander's wave of decay 1, and the time after it.
ChestWallResponse under_blast(const double peak, const double duration)
{
  std::vector<double> times, pressures;
  for (unsigned int i = 0; i <= 4000; ++i)
  {
    const double s = i / 1000.;
    times.push_back(s * duration);
    pressures.push_back(peak * (1. - s) * std::exp(-s));
  }
  return chest_wall_response(times, pressures, ambient);
}
} // namespace

// The figures were computed independently, with four digits.
TEST(ChestWall, ReproducesFiguresOfSimpleWaves)
{
  EXPECT_NEAR(under_blast(100e3, 2e-3).velocity, 1.922, 1e-3);
  EXPECT_NEAR(under_blast(200e3, 2e-3).velocity, 3.830, 1e-3);
  EXPECT_NEAR(under_blast(200e3, 5e-3).velocity, 6.020, 1e-3);
  EXPECT_NEAR(under_blast(400e3, 5e-3).velocity, 11.547, 2e-3);
}

// For a weak and short load neither spring nor lung nor damper matter: the
// impulse per area over the mass per area.
TEST(ChestWall, MovesWithTheImpulseAtFirst)
{
  const double pressure = 100., duration = 1e-6;
  const auto response = chest_wall_response(
    {0., duration, duration * 1.001}, {pressure, pressure, 0.}, ambient);
  const double free = 0.082 / 2.03 * pressure * duration;
  EXPECT_NEAR(response.velocity / free, 1., 1e-3);
}

// A steady load ends where spring and lung balance it.
TEST(ChestWall, ComesToRestWhereTheLungHoldsTheLoad)
{
  const double load = 50e3;
  const auto response =
    chest_wall_response({0., 5., 5.000001}, {load, load, load}, ambient);
  const double x = response.displacement;
  EXPECT_GT(x, 0.004);
  EXPECT_GE(0.082 * response.lung_pressure + 989. * x, 0.082 * load * 0.999);
}

TEST(ChestWall, RefusesTimesThatDoNotIncrease)
{
  EXPECT_THROW(chest_wall_response({0., 0.}, {1., 1.}, ambient), InputError);
  EXPECT_THROW(chest_wall_response({0., 1.}, {1.}, ambient), InputError);
}

// A load that no body survives does not stop a run either.
TEST(ChestWall, StandsLoadsBeyondAllReason)
{
  const auto response =
    chest_wall_response({0., 1e-5, 1e-2}, {0., 1e10, 1e10}, ambient);
  EXPECT_GT(response.velocity, 1e3);
  EXPECT_TRUE(std::isfinite(response.velocity));
  EXPECT_TRUE(std::isfinite(response.lung_pressure));
}

TEST(ChestWall, NamesTheBandOfInjury)
{
  EXPECT_EQ(thorax_injury_band(3.5), "none");
  EXPECT_EQ(thorax_injury_band(3.6), "trace");
  EXPECT_EQ(thorax_injury_band(17.), "lethal to most");
  // One where slight injury begins.
  EXPECT_NEAR(thorax_injury_index(0.876 / 0.117), 1., 1e-12);
  EXPECT_NEAR(thorax_injury_index(7.5), 1., 0.01);
}

TEST(BlastInjury, FollowsBowensCurve)
{
  const double durations[] = {1e-3, 3e-3, 5e-3, 10e-3, 20e-3};
  const double lethal[] = {3290e3, 1315e3, 941e3, 671e3, 542e3};
  for (unsigned int i = 0; i < 5; ++i)
  {
    const double p =
      lung_median_lethal_overpressure(durations[i], 70., ambient);
    EXPECT_NEAR(p / lethal[i], 1., 1e-3) << durations[i];
    EXPECT_DOUBLE_EQ(lung_threshold_overpressure(durations[i], 70., ambient),
                     p / 5.);
  }
  // A child suffers from a shorter wave as a man from a longer one.
  EXPECT_NEAR(lung_median_lethal_overpressure(1e-3, 8.75, ambient) /
                lung_median_lethal_overpressure(2e-3, 70., ambient),
              1.,
              1e-12);
}

// UFC 3-340-02 (2008), table 1-1, for 3 to 5 ms: half die at 130 to 180 psi,
// lungs are damaged from 30 to 40 psi on.
TEST(BlastInjury, AgreesWithTheTableOfTolerances)
{
  const double median = lung_median_lethal_overpressure(4e-3, 70., ambient);
  EXPECT_GT(median, 130. * psi);
  EXPECT_LT(median, 180. * psi);
  const double threshold = lung_threshold_overpressure(4e-3, 70., ambient);
  EXPECT_GT(threshold, 30. * psi);
  EXPECT_LT(threshold, 40. * psi);
}

TEST(BlastInjury, LethalityFollowsTheExposure)
{
  EXPECT_DOUBLE_EQ(lung_lethality_probability(1.), 0.5);
  EXPECT_NEAR(lung_lethality_probability(0.66), 0.01, 2e-4);
  EXPECT_NEAR(lung_lethality_probability(1. / 0.66), 0.99, 2e-4);
  EXPECT_EQ(lung_lethality_probability(0.), 0.);
  EXPECT_LT(lung_lethality_probability(0.2), 1e-12);
}

// S. Glasstone, P. J. Dolan, The Effects of Nuclear Weapons (1977), table 3.07.
TEST(BlastInjury, DynamicPressureIsThatOfTheTable)
{
  const std::pair<double, double> table[] = {
    {100., 123.}, {50., 41.}, {30., 17.}, {20., 8.1}, {10., 2.2}};
  for (const auto &[overpressure, dynamic] : table)
    EXPECT_NEAR(
      dynamic_pressure(overpressure * psi, ambient) / psi / dynamic, 1., 0.02)
      << overpressure;
  EXPECT_DOUBLE_EQ(standing_load(2e5, ambient),
                   2e5 + dynamic_pressure(2e5, ambient));
}

// NASA-STD-8719.12A, table E-1: 50 % at 15.0 psi, 99 % at 74.4 psi.
TEST(BlastInjury, BreaksHalfOfTheEardrumsAt104Kilopascal)
{
  EXPECT_NEAR(eardrum_rupture_probability(15. * psi), 0.5, 5e-3);
  EXPECT_NEAR(eardrum_rupture_probability(74.4 * psi), 0.99, 3e-3);
  EXPECT_NEAR(eardrum_rupture_probability(103.7e3), 0.5, 1e-3);
  EXPECT_LT(eardrum_rupture_probability(34.5e3), 0.05);
  EXPECT_GT(eardrum_rupture_probability(400e3), 0.97);
  EXPECT_EQ(eardrum_rupture_probability(-1.), 0.);
}

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
  EXPECT_EQ(first_positive_phase(times, {0., 0., 8., 4., 0., 6., 6.}), 2.);
  EXPECT_EQ(first_positive_phase(times, {0., -1., .1, 8., 4., 6., 6.}), 3.);
  EXPECT_EQ(first_positive_phase(times, {0., -1., -1., 0., 0., 0., 0.}), 0.);
  const LoadInjury none = load_injury(times, std::vector<double>(7, 0.), 70.);
  EXPECT_EQ(none.lung_exposure, 0.);
  EXPECT_EQ(none.eardrum_rupture, 0.);
  EXPECT_EQ(none.chest_wall_velocity, 0.);
}

// Of a rectangle of 100 g and 10 ms: 0.01 s times 100^2.5; no longer window has
// more, and a shorter one has its part.
TEST(HeadInjury, OfARectangleIsExact)
{
  std::vector<double> times, accelerations;
  for (unsigned int i = 0; i <= 100; ++i)
  {
    times.push_back(1e-4 * i);
    accelerations.push_back(100. * 9.80665);
  }
  EXPECT_NEAR(
    head_injury_criterion(times, accelerations, 15e-3).value, 1000., 1e-9);
  const auto shorter = head_injury_criterion(times, accelerations, 4e-3);
  EXPECT_NEAR(shorter.value, 400., 1e-9);
  EXPECT_NEAR(shorter.end - shorter.begin, 4e-3, 1e-12);
}

// The same motion, given by velocities that turn half-way.
TEST(HeadInjury, OfVelocitiesCountsEachChange)
{
  std::vector<double> times;
  std::vector<std::array<double, 3>> velocities;
  for (unsigned int i = 0; i <= 300; ++i)
  {
    times.push_back(1e-4 * i);
    const double gained = 980.665e-4 * i;
    velocities.push_back({{0., std::min(gained, 4.903325), 0.}});
    velocities.back()[2] = std::max(0., std::min(gained, 9.80665) - 4.903325);
  }
  EXPECT_NEAR(
    head_injury_criterion(times, velocities, 15e-3).value, 1000., 1e-6);
  EXPECT_NEAR(head_injury_criterion(times, velocities, 5e-3).value, 500., 1e-6);
  velocities.pop_back();
  EXPECT_THROW(head_injury_criterion(times, velocities, 1.), InputError);
}

// Of half a sine of peak a and length T, 0.4146 a^2.5 T over 0.6626 T (the
// maximum of s (2 sin(pi s / 2) / (pi s))^2.5).
TEST(HeadInjury, OfHalfASineIsKnown)
{
  const unsigned int n = 2000;
  const double length = 10e-3, peak = 150.;
  std::vector<double> times, accelerations;
  for (unsigned int i = 0; i <= n; ++i)
  {
    times.push_back(length * i / n);
    accelerations.push_back(peak * 9.80665 * std::sin(M_PI * i / n));
  }
  double best = 0.;
  for (double s = 0.01; s <= 1.; s += 1e-4)
    best = std::max(
      best, s * std::pow(2. * std::sin(M_PI * s / 2.) / (M_PI * s), 2.5));
  EXPECT_NEAR(best, 0.4146, 1e-4);
  const auto criterion = head_injury_criterion(times, accelerations, 15e-3);
  EXPECT_NEAR(
    criterion.value / (best * length * std::pow(peak, 2.5)), 1., 1e-5);
  const std::vector<double> one(1, 0.);
  EXPECT_THROW(head_injury_criterion(one, one, 1.), InputError);
}

TEST(HeadInjury, BrainCriterionIsOneAtEachCriticalVelocity)
{
  EXPECT_DOUBLE_EQ(brain_injury_criterion({{66.25, 0., 0.}}), 1.);
  EXPECT_DOUBLE_EQ(brain_injury_criterion({{0., 0., -42.87}}), 1.);
}

TEST(HeadInjury, PercentilesCountWeights)
{
  const std::vector<double> strains = {0.3, 0.1, 0.2}, volumes = {1., 7., 2.};
  EXPECT_EQ(weighted_percentile(strains, volumes, 0.7), 0.1);
  EXPECT_EQ(weighted_percentile(strains, volumes, 0.71), 0.2);
  EXPECT_EQ(weighted_percentile(strains, volumes, 1.), 0.3);
  EXPECT_NEAR(weighted_part_above(strains, volumes, 0.15), 0.3, 1e-15);
  EXPECT_THROW(weighted_percentile({}, {}, 0.5), InputError);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/injury/blast_injury.h>
#include <contrecoup/numerics/injury/channel_filter.h>
#include <contrecoup/numerics/injury/chest_wall.h>
#include <contrecoup/numerics/injury/head_injury.h>
#include <contrecoup/numerics/injury/injury_criteria.h>
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

// Followed in steps of any length, the motion is that under the whole history.
TEST(ChestWall, FollowedStepByStepIsThatOfTheHistory)
{
  std::vector<double> times{0.}, overpressures{0.};
  for (unsigned int i = 0; i < 900; ++i)
  {
    times.push_back(times.back() + (i % 3 == 0 ? 2e-6 : 1.3e-5));
    const double s = times.back() / 4e-3;
    overpressures.push_back(250e3 * (1. - s) * std::exp(-s));
  }
  ChestWall wall;
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    wall.advance(
      overpressures[i], overpressures[i + 1], times[i + 1] - times[i], ambient);
  const auto whole = chest_wall_response(times, overpressures, ambient);
  EXPECT_DOUBLE_EQ(wall.largest_velocity, whole.velocity);
  EXPECT_DOUBLE_EQ(wall.largest_displacement, whole.displacement);
  // The same samples in steps of a twentieth.
  ChestWall fine;
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    for (unsigned int k = 0; k < 20; ++k)
    {
      const auto at = [&](const unsigned int part) {
        return overpressures[i] +
               part / 20. * (overpressures[i + 1] - overpressures[i]);
      };
      fine.advance(at(k), at(k + 1), (times[i + 1] - times[i]) / 20., ambient);
    }
  EXPECT_NEAR(fine.displacement, wall.displacement, 1e-9 * 0.01);
  EXPECT_NEAR(fine.largest_velocity, whole.velocity, 1e-6 * whole.velocity);
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

// Axelsson and Yelverton give the levels by velocity and by index, with one
// digit behind the point: each velocity gives the index of its level.
TEST(ChestWall, IndexOfEachLevelIsThatOfTheSource)
{
  const std::pair<double, double> levels[] = {
    {3.6, 0.2}, {7.5, 1.}, {4.3, 0.3}, {9.8, 1.9}, {12.8, 3.6}, {16.9, 7.1}};
  for (const auto &[velocity, index] : levels)
    EXPECT_NEAR(thorax_injury_index(velocity), index, 0.051) << velocity;
  EXPECT_NEAR(thorax_injury_index(0.876 / 0.117), 1., 1e-12);
}

TEST(InjuryCriteria, LevelsOfTheChestOverlap)
{
  const InjuryCriterion chest = injury_criterion("chest_wall_mean");
  EXPECT_EQ(chest.meaning(3.5), "none");
  EXPECT_EQ(chest.meaning(4.), "trace to slight");
  EXPECT_EQ(chest.meaning(5.), "trace to slight or slight to moderate");
  EXPECT_EQ(chest.meaning(8.), "slight to moderate or moderate to extensive");
  EXPECT_EQ(chest.meaning(11.), "moderate to extensive");
  EXPECT_EQ(chest.meaning(13.),
            "moderate to extensive or lethality above 50 %");
  EXPECT_EQ(chest.meaning(20.), "lethality above 50 %");
  EXPECT_EQ(chest.thresholds.size(), 6U);
  // One side has none.
  EXPECT_TRUE(injury_criterion("chest_wall_front").thresholds.empty());
  EXPECT_THROW(injury_criterion("chest_wall"), InputError);
}

// NHTSA: 31 % for injuries of AIS 2 at a HIC of 700, 47 % at 1000.
TEST(InjuryCurves, OfTheHeadAreThoseOfNhtsa)
{
  const InjuryCurve slight = injury_curve("hic15_ais2");
  EXPECT_NEAR(slight.probability(700.), 0.31, 0.005);
  EXPECT_NEAR(slight.probability(1000.), 0.474, 0.005);
  EXPECT_NEAR(
    injury_curve("hic15_ais3").probability(std::exp(7.45231)), 0.5, 1e-12);
  for (const double hic : {100., 300., 1000., 3000.})
  {
    EXPECT_GT(slight.probability(hic),
              injury_curve("hic15_ais3").probability(hic));
    EXPECT_GT(injury_curve("hic15_ais3").probability(hic),
              injury_curve("hic15_ais4").probability(hic));
  }
  // The fits cross at 5297 and 51000; AIS 3 or worse includes AIS 4.
  for (const double hic : {5200., 8246., 1e5})
  {
    EXPECT_GE(slight.probability(hic),
              injury_curve("hic15_ais3").probability(hic));
    EXPECT_GE(injury_curve("hic15_ais3").probability(hic),
              injury_curve("hic15_ais4").probability(hic));
  }
  EXPECT_EQ(slight.probability(0.), 0.);
  EXPECT_EQ(slight.probability(-1.), 0.);
  EXPECT_THROW(injury_curve("hic15"), InputError);
  EXPECT_THROW(injury_curve("lung_median_lethal_load").probability(1.),
               InputError);
}

// 1 - 1/e at the scale of each curve; the thresholds are the medians.
TEST(InjuryCurves, OfTheBrainHaveTheirMediansAsThresholds)
{
  EXPECT_NEAR(injury_curve("bric_ais2").probability(0.602), 0.6321, 1e-4);
  const InjuryCriterion bric = injury_criterion("injury_bric");
  ASSERT_EQ(bric.curves.size(), bric.thresholds.size());
  for (std::size_t i = 0; i < bric.curves.size(); ++i)
    EXPECT_NEAR(
      injury_curve(bric.curves[i]).probability(bric.thresholds[i].first),
      0.5,
      1e-3);
}

TEST(InjuryCriteria, AreToldInWords)
{
  const InjuryCriterion lowest =
    injury_criterion("injury_intracranial_pressure_lowest");
  EXPECT_EQ(lowest.meaning(-99e3), "none");
  EXPECT_EQ(lowest.meaning(-101e3), "fluid may cavitate");
  EXPECT_EQ(lowest.in_words().substr(0, 32),
            "-100000 Pa: fluid may cavitate (");
  EXPECT_EQ(injury_criterion("injury_cavitation_dose").in_words(),
            "no threshold (none is published)");
  // Entries differ between the applications that share these words.
  for (const std::string &name : injury_measures_of({"head", "chest"}))
    EXPECT_EQ(injury_criterion(name).limits.find('/'), std::string::npos)
      << name;
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
  const double threshold = 0.2 * median;
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

TEST(BlastInjury, LoadInFlowIsTheShockAtMost)
{
  const double shock = dynamic_pressure(2e5, ambient);
  EXPECT_DOUBLE_EQ(load_in_flow(2e5, shock, ambient),
                   standing_load(2e5, ambient));
  // Before a wall the gas rests; products carry more than a shock.
  EXPECT_DOUBLE_EQ(load_in_flow(2e5, 0., ambient), 2e5);
  EXPECT_DOUBLE_EQ(load_in_flow(2e5, 10. * shock, ambient), 2e5 + shock);
  EXPECT_EQ(load_in_flow(-1e4, 1e5, ambient), 0.);
  EXPECT_TRUE(is_habitable(ambient));
  EXPECT_FALSE(is_habitable(20e3));
  EXPECT_FALSE(is_habitable(1e6));
}

// 941 kPa of 5 ms kill half of men of 70 kg (Bowen et al. 1968).
TEST(BlastInjury, InTheAirFollowsFromPeakLoadAndPhase)
{
  const AirInjury half = air_injury({6e5, 5e-3}, 941e3, ambient, 70.);
  EXPECT_NEAR(half.lung_exposure, 1., 1e-3);
  EXPECT_NEAR(half.lung_lethality, 0.5, 3e-3);
  EXPECT_DOUBLE_EQ(half.eardrum_rupture, eardrum_rupture_probability(6e5));
  const AirInjury none = air_injury({6e5, 0.}, 941e3, ambient, 70.);
  EXPECT_EQ(none.lung_exposure, 0.);
  EXPECT_EQ(none.lung_lethality, 0.);
  EXPECT_EQ(none.eardrum_rupture, 0.);
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

// A rectangle of 100 g and 10 ms has 0.01 s times 100^2.5; no longer window has
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

// Half a sine of peak a and length T has 0.4146 a^2.5 T over 0.6626 T (the
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

namespace
{
/// Gain [dB] of the filter of CFC 1000 for a long sine of a frequency [Hz].
double gain_of_head_filter(const double frequency, const double interval)
{
  std::vector<double> values;
  for (double time = 0.; time < 0.1; time += interval)
    values.push_back(std::sin(2. * M_PI * frequency * time));
  const std::vector<double> filtered =
    channel_class_filter(values, interval, head_channel_class);
  double before = 0., after = 0.;
  // Far from the ends.
  for (std::size_t i = values.size() / 4; i < values.size() * 3 / 4; ++i)
  {
    before += values[i] * values[i];
    after += filtered[i] * filtered[i];
  }
  return 10. * std::log10(after / before);
}
} // namespace

// SAE J211/1 and ISO 6487 for CFC 1000: +0.5 to -1 dB at 1000 Hz, +0.5 to -4 dB
// at 1650 Hz; the pair of filters halves the power at 5/3 of the class.
TEST(ChannelFilter, KeepsTheCorridorOfTheNorm)
{
  for (const double interval : {1e-5, 4e-5})
  {
    EXPECT_NEAR(gain_of_head_filter(100., interval), 0., 0.01);
    const double at_class = gain_of_head_filter(1000., interval);
    EXPECT_LT(at_class, 0.5);
    EXPECT_GT(at_class, -1.);
    const double at_corner = gain_of_head_filter(1650., interval);
    EXPECT_LT(at_corner, 0.5);
    EXPECT_GT(at_corner, -4.);
  }
  EXPECT_NEAR(gain_of_head_filter(1000., 5e-6), -0.454, 0.01);
  EXPECT_NEAR(gain_of_head_filter(1650., 5e-6), -2.909, 0.02);
  EXPECT_NEAR(gain_of_head_filter(1666.66, 5e-6), -3.010, 0.02);
  EXPECT_LT(gain_of_head_filter(10000., 5e-6), -50.);
}

// Straight lines pass unchanged up to both ends, and nothing is shifted.
TEST(ChannelFilter, ShiftsNothing)
{
  std::vector<double> line, pulse;
  for (unsigned int i = 0; i <= 2000; ++i)
  {
    line.push_back(3. + 0.5 * i);
    pulse.push_back(std::exp(-std::pow((i - 800.) / 30., 2)));
  }
  const std::vector<double> same = channel_class_filter(line, 1e-5, 1000.);
  for (unsigned int i = 0; i <= 2000; i += 100)
    EXPECT_NEAR(same[i], line[i], 1e-6) << i;
  const std::vector<double> wider = channel_class_filter(pulse, 1e-5, 1000.);
  for (unsigned int i = 1; i < 100; ++i)
    EXPECT_NEAR(wider[800 - i], wider[800 + i], 1e-9);
  EXPECT_LT(wider[800], pulse[800]);
  EXPECT_THROW(channel_class_filter(line, 2.1e-4, 1000.), InputError);
}

// Histories of unequal times, and of few.
TEST(ChannelFilter, TakesHistories)
{
  VectorHistory history;
  for (unsigned int i = 0; i <= 1000; ++i)
  {
    const double time = 1e-5 * (i + 0.3 * (i % 2));
    history.times.push_back(time);
    history.values.push_back({{2. * time, 0., -time}});
  }
  const VectorHistory same = channel_class_filter(history, 1000.);
  ASSERT_EQ(same.times.size(), 1001U);
  for (unsigned int i = 0; i <= 1000; i += 50)
  {
    EXPECT_NEAR(same.values[i][0], 2. * same.times[i], 1e-8);
    EXPECT_NEAR(same.values[i][2], -same.times[i], 1e-8);
  }
  const VectorHistory few =
    channel_class_filter({{0., 0.01}, {{{0., 0., 0.}}, {{1., 0., 0.}}}}, 1000.);
  EXPECT_EQ(few.times.size(), 101U);
  EXPECT_NEAR(few.values[50][0], 0.5, 1e-8);
  EXPECT_THROW(channel_class_filter({{0.}, {{}}}, 1000.), InputError);
  EXPECT_THROW(channel_class_filter({{0., 0.}, {{}, {}}}, 1000.), InputError);
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
  EXPECT_THROW(weighted_percentile({}, {}, 0.5), InputError);
}

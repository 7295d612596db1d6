// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/injury/wave_reflection.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;

namespace
{
constexpr double sea_pressure = 101325., air_density = 1.225;

double earliest(const double energy, const double distance)
{
  return earliest_front(energy, sea_pressure, air_density, distance);
}
} // namespace


// The tables, with 0.62 times the mass of ANFO in TNT, come 1.0 to 5.9 % before
// the point source.
TEST(WaveReflection, ComesNoLaterThanPointSourceAndTables)
{
  for (const std::string &name : explosive_names())
  {
    const Explosive &explosive = find_explosive(name);
    const double energy =
      explosive.jwl.energy_density / explosive.jwl.reference_density +
      explosive.afterburn.energy;
    const IncidentWave wave(explosive.tnt, 1., energy);
    const ExpectedBlast source(energy, sea_pressure, air_density);
    for (double distance = 0.1; distance < 100.; distance *= 1.1)
    {
      const double time = earliest(energy, distance);
      EXPECT_LE(time, source.arrival(distance)) << name << distance;
      EXPECT_LE(time, wave.value(BlastQuantity::arrival, distance))
        << name << distance;
      EXPECT_GT(time, 0.6 * source.arrival(distance)) << name << distance;
      EXPECT_LT(time, earliest(energy, 1.1 * distance)) << name << distance;
    }
  }
}

// A blast in air of a third of the pressure and density is that of three times
// the energy.
TEST(WaveReflection, ScalesWithThePressure)
{
  for (const double distance : {1., 10.})
    EXPECT_NEAR(
      earliest_front(4e6, sea_pressure / 3., air_density / 3., distance) /
        earliest(12e6, distance),
      1.,
      1e-9);
  const ReflectionWay way{20., 2., 1.};
  for (const double energy : {1e6, 1e7, 1e8})
    EXPECT_EQ(merges_with_reflection(energy, sea_pressure / 3., way),
              merges_with_reflection(3. * energy, sea_pressure, way));
}

// A charge of 1 kg of TNT, by the angle at which its front meets a plane.
TEST(WaveReflection, MergesAtGrazingAngle)
{
  const auto merges = [](const double direct, const double before) {
    return merges_with_reflection(
      4.184e6, sea_pressure, {direct, before, before});
  };
  EXPECT_TRUE(merges(10., 0.09));
  EXPECT_TRUE(merges(10., 0.5));
  EXPECT_FALSE(merges(10., 5.));
  EXPECT_FALSE(merges(1., 0.5));
  const ReflectionWay way{4., 1., 2.25};
  EXPECT_DOUBLE_EQ(way.mirrored(), 5.);
  const IncidentWave wave({1., 1., true, ""}, 1., 4.184e6);
  const double delay = reflection_delay(wave, way).least;
  EXPECT_GT(delay, 0.);
  EXPECT_LT(delay,
            wave.value(BlastQuantity::arrival, 5.) -
              wave.value(BlastQuantity::arrival, 4.));
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/injury/incident_wave.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;

namespace
{
// Not a global object: the tables that it reads are one of another source.
IncidentWave two_kilograms()
{
  return IncidentWave(TntEquivalence{1.37, 1.19, true, ""}, 2., 18e6);
}
} // namespace

TEST(IncidentWave, IsThatOfTheTablesWithBothEquivalences)
{
  const IncidentWave wave = two_kilograms();
  const KingeryBulmash pressures("spherical", 2. * 1.37);
  const KingeryBulmash impulses("spherical", 2. * 1.19);
  for (const auto &[quantity, tables] :
       {std::pair{BlastQuantity::overpressure, &pressures},
        {BlastQuantity::reflected_overpressure, &pressures},
        {BlastQuantity::arrival, &pressures},
        {BlastQuantity::impulse, &impulses},
        {BlastQuantity::reflected_impulse, &impulses},
        {BlastQuantity::duration, &impulses}})
  {
    EXPECT_TRUE(wave.is_tabulated(quantity, 2.));
    EXPECT_EQ(wave.value(quantity, 2.), tables->value(quantity, 2.));
  }
  EXPECT_EQ(wave.nearest_duration(2.),
            impulses.value(BlastQuantity::duration, 2.));
}

// M. Swisdak (ADA526744, 1994): as 1.8 times the mass in free air.
TEST(IncidentWave, OfASurfaceBurstIsThatOfAlmostTwiceTheMass)
{
  const TntEquivalence tnt{1., 1., true, ""};
  const IncidentWave ground(tnt, 1., 4e6, true);
  const IncidentWave air(tnt, IncidentWave::surface_mass, 4e6);
  for (const double distance : {1.5, 2., 3., 5., 10.})
    for (const BlastQuantity quantity :
         {BlastQuantity::overpressure, BlastQuantity::impulse})
      EXPECT_NEAR(ground.value(quantity, distance) /
                    air.value(quantity, distance),
                  1.,
                  0.1)
        << distance;
  // Beyond the tables, too.
  EXPECT_NEAR(ground.value(BlastQuantity::overpressure, 100.) /
                air.value(BlastQuantity::overpressure, 100.),
              1.,
              0.1);
}


TEST(IncidentWave, IsOfASurfaceBurstBelowATenthOfTheScalingLength)
{
  // 8 kg: 0.2 m, and five heights away.
  EXPECT_TRUE(IncidentWave::is_surface_burst(8., 0.199, 2.));
  EXPECT_FALSE(IncidentWave::is_surface_burst(8., 0.201, 2.));
  EXPECT_FALSE(IncidentWave::is_surface_burst(8., 0.199, 0.99));
}


// The tables end at 40 m per cube root of the mass in kg.
TEST(IncidentWave, IsContinuedByThePointSourceBeyondTheTables)
{
  const IncidentWave wave = two_kilograms();
  const ExpectedBlast source(18e6, 101325., 1.225);
  const double far = 100.;
  const double end = 40. * std::cbrt(2. * 1.37);
  EXPECT_FALSE(wave.is_tabulated(BlastQuantity::overpressure, far));
  const auto pressure = [&](const double distance) {
    return wave.value(BlastQuantity::overpressure, distance);
  };
  const auto arrival = [&](const double distance) {
    return wave.value(BlastQuantity::arrival, distance);
  };
  EXPECT_NEAR(pressure(far) / pressure(end - 1e-3),
              source.overpressure(far) / source.overpressure(end),
              1e-4);
  EXPECT_NEAR(arrival(far) - arrival(end - 1e-3),
              source.arrival(far) - source.arrival(end),
              1e-4);
  EXPECT_TRUE(std::isnan(wave.value(BlastQuantity::impulse, far)));
  EXPECT_GT(wave.nearest_duration(far), wave.nearest_duration(2.));

  // From within the charge to the far field: no jump, no rise with distance.
  for (double distance = 0.05; distance < 500.; distance *= 1.01)
  {
    EXPECT_LE(pressure(1.01 * distance), pressure(distance)) << distance;
    EXPECT_GE(pressure(1.01 * distance), 0.93 * pressure(distance)) << distance;
    EXPECT_GE(arrival(1.01 * distance), arrival(distance)) << distance;
    EXPECT_LE(arrival(1.01 * distance), 1.05 * arrival(distance)) << distance;
  }
}


TEST(IncidentWave, FindsTheEndOfTheTables)
{
  // Both masses scale; the end of each is 40 m/kg^(1/3).
  const IncidentWave wave = two_kilograms();
  const double farthest = wave.nearest_tabulated(1000.);
  EXPECT_NEAR(farthest, 40. * std::cbrt(2. * 1.19), 1e-4);
  EXPECT_TRUE(wave.is_tabulated(farthest));
  EXPECT_NEAR(wave.nearest_tabulated(500.), farthest, 1e-3);
  EXPECT_EQ(wave.nearest_tabulated(3.), 3.);
}

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

// The tables end at 40 m per cube root of the mass in kg.
TEST(IncidentWave, IsThatOfThePointSourceBeyondTheTables)
{
  const IncidentWave wave = two_kilograms();
  const ExpectedBlast source(18e6, 101325., 1.225);
  const double far = 100.;
  EXPECT_FALSE(wave.is_tabulated(BlastQuantity::overpressure, far));
  EXPECT_EQ(wave.value(BlastQuantity::overpressure, far),
            source.overpressure(far));
  EXPECT_EQ(wave.value(BlastQuantity::arrival, far), source.arrival(far));
  EXPECT_TRUE(std::isnan(wave.value(BlastQuantity::impulse, far)));
  EXPECT_GT(wave.nearest_duration(far), wave.nearest_duration(2.));
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

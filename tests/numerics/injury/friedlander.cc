// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/injury/friedlander.h>
#include <contrecoup/numerics/injury/kingery_bulmash.h>

#include <gtest/gtest.h>

using namespace contrecoup;

namespace
{
/// By the rule of midpoints.
double integral(const Friedlander &pulse)
{
  const unsigned int n = 100000;
  const double step = pulse.duration / n;
  double sum = 0.;
  for (unsigned int i = 0; i < n; ++i)
    sum += step * pulse.value(pulse.arrival + (i + 0.5) * step);
  return sum;
}
} // namespace


TEST(Friedlander, PulseHasItsImpulse)
{
  for (const double impulse : {1., 20., 80., 99., 130.})
  {
    const Friedlander pulse = friedlander_pulse(1e-3, 1e5, 2e-3, impulse);
    EXPECT_NEAR(pulse.impulse(), impulse, 1e-9 * impulse);
    EXPECT_NEAR(integral(pulse), impulse, 1e-6 * impulse);
    EXPECT_EQ(pulse.value(0.99e-3), 0.);
    EXPECT_NEAR(pulse.value(1e-3), 1e5, 1e-6);
    EXPECT_EQ(pulse.value(pulse.arrival + 1.01 * pulse.duration), 0.);
    EXPECT_LT(pulse.value(pulse.arrival + 1.01 * pulse.duration, true), 0.);
  }
  EXPECT_THROW(friedlander_pulse(0., 1e5, 0., 1.), InputError);
}


// Weak shocks double, strong ones are eightfold; between, the tables.
TEST(Friedlander, Reflection)
{
  EXPECT_NEAR(reflected_overpressure(1., 1e5), 2., 1e-4);
  EXPECT_NEAR(reflected_overpressure(1e12, 1e5), 8e12, 1e7);
  const KingeryBulmash table("spherical", 1.);
  for (const double distance : {2., 5., 10.})
  {
    const double side_on = table.value(BlastQuantity::overpressure, distance);
    const double wall =
      table.value(BlastQuantity::reflected_overpressure, distance);
    EXPECT_NEAR(reflected_overpressure(side_on, 101325.) / wall, 1., 0.05);
  }
}


TEST(Friedlander, Angle)
{
  EXPECT_EQ(pressure_at_angle(1., 3., 1.), 3.);
  EXPECT_EQ(pressure_at_angle(1., 3., 0.), 1.);
  EXPECT_EQ(pressure_at_angle(1., 3., -0.7), 1.);
  EXPECT_NEAR(pressure_at_angle(1., 3., 0.5), 3. / 4. + 1., 1e-15);
}

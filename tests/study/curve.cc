// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/study/curve.h>

#include <gtest/gtest.h>

#include <fstream>

using namespace contrecoup::study;

namespace
{
/// Rises by 2 at time 1 within 0.5, falls to 1 below the start until 3.
const Curve wave = {{0., 1., 1.5, 3., 4.}, {10., 10., 12., 9., 10.}};
} // namespace

TEST(Curve, IsReadByNameWithoutUnit)
{
  std::ofstream("table.csv") << "time [s],probe_1_pressure [Pa],step\n"
                                "0,1e5,0\n0.5,2e5,1\n";
  const Curve curve = read_curve("table.csv", "probe_1_pressure");
  EXPECT_EQ(curve.times, (std::vector<double>{0., 0.5}));
  EXPECT_EQ(curve.values, (std::vector<double>{1e5, 2e5}));
  try
  {
    read_curve("table.csv", "probe_1_presure");
    FAIL();
  }
  catch (const contrecoup::InputError &error)
  {
    EXPECT_NE(std::string(error.what()).find("probe_1_pressure"),
              std::string::npos);
  }
  EXPECT_THROW(read_curve("no_such.csv", "x"), contrecoup::InputError);
}

TEST(Curve, HasPeakImpulseAndArrival)
{
  EXPECT_DOUBLE_EQ(peak(wave), 2.);
  EXPECT_DOUBLE_EQ(lowest(wave), -1.);
  EXPECT_DOUBLE_EQ(lowest({{0., 1.}, {3., 4.}}), 0.);
  // A triangle over 0.5 s, and one of 1 s down to the first value.
  EXPECT_DOUBLE_EQ(arrival(wave), 1.25);
  EXPECT_DOUBLE_EQ(impulse({{0., 1., 1.5, 2.5, 4.}, {10., 10., 12., 10., 9.}}),
                   1.5);
}

TEST(Curve, DifferenceIsRelativeToTheReferencesRise)
{
  EXPECT_DOUBLE_EQ(relative_difference(wave, wave), 0.);
  // Twice the rise, on other times, longer than the reference.
  const Curve twice = {{0., 1., 1.25, 1.5, 3., 4., 9.},
                       {10., 10., 12., 14., 8., 10., 50.}};
  EXPECT_NEAR(relative_difference(twice, wave), 1., 1e-12);
  // A shift by a constant: 4 s * 0.5 over the areas 0.5 + 1 + 0.25 + 0.5.
  Curve shifted = wave;
  for (double &value : shifted.values)
    value += 0.5;
  EXPECT_NEAR(relative_difference(shifted, wave), 2. / 2.25, 1e-12);
}

TEST(Curve, AverageIsTheMeanOverAnInterval)
{
  // A straight curve stays, but where the interval ends with the curve.
  const Curve straight = {{0., 1., 3., 4.}, {0., 2., 6., 8.}};
  const Curve same = averaged(straight, 2.);
  EXPECT_EQ(same.times, straight.times);
  EXPECT_NEAR(same.values[0], 1., 1e-12);
  EXPECT_NEAR(same.values[1], 2., 1e-12);
  EXPECT_NEAR(same.values[2], 6., 1e-12);
  EXPECT_NEAR(same.values[3], 7., 1e-12);
  // A tooth of area 1 within the interval.
  const Curve tooth = {{0., 1., 2., 3., 4.}, {0., 0., 1., 0., 0.}};
  EXPECT_NEAR(averaged(tooth, 2.).values[2], 0.5, 1e-12);
  EXPECT_NEAR(averaged(tooth, 1.).values[2], 0.75, 1e-12);
  // Oscillations of a period vanish where the interval is one.
  Curve fast;
  for (unsigned int i = 0; i <= 400; ++i)
  {
    fast.times.push_back(0.01 * i);
    fast.values.push_back(3. + (i % 4 < 2 ? 1. : -1.));
  }
  const Curve slow = averaged(fast, 0.04);
  for (unsigned int i = 2; i + 2 < slow.values.size(); ++i)
    EXPECT_NEAR(slow.values[i], 3., 1e-12);
}

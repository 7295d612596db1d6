// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/run/remaining_time.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;

TEST(RemainingTime, NothingIsKnownBeforeTheFirstStep)
{
  const RemainingTime remaining;
  EXPECT_TRUE(std::isnan(remaining.left(0., 1.)));
  EXPECT_EQ(remaining.left(1., 1.), 0.);
}

TEST(RemainingTime, UniformRunsAreKnownFromTheirFirstStep)
{
  RemainingTime remaining;
  for (unsigned int i = 1; i <= 1000; ++i)
  {
    remaining.add(1e-3, 64., 0.02);
    ASSERT_NEAR(remaining.left(1. + 1e-3 * i, 2.), 20. - 0.02 * i, 1e-9) << i;
  }
}

// A step gets a hundred times as dear: after ten memories of thirty seconds
// the cheap ones count for nothing.
TEST(RemainingTime, OldStepsAreForgotten)
{
  RemainingTime remaining;
  for (unsigned int i = 0; i < 1000; ++i)
    remaining.add(1e-3, 64., 0.01);
  for (unsigned int i = 0; i < 300; ++i)
    remaining.add(1e-3, 64., 1.);
  EXPECT_NEAR(remaining.left(0., 1.), 1000., 10.);
  remaining.restart();
  remaining.add(1e-3, 64., 1.);
  EXPECT_NEAR(remaining.left(0., 1.), 1000., 1e-9);
}

// 10 updates per second of simulated time until 2 s, 50 until 3 s, then 1.
TEST(RemainingTime, FollowsTheForecastOfTheSolver)
{
  RemainingTime remaining;
  remaining.set_forecast({{2., 10.}, {3., 50.}, {5., 1.}});
  remaining.add(0.5, 100., 25.);
  EXPECT_NEAR(remaining.left(0., 5.), 0.25 * (20. + 50. + 2.), 1e-12);
  EXPECT_NEAR(remaining.left(1.5, 2.5), 0.25 * (5. + 25.), 1e-12);
  EXPECT_NEAR(remaining.left(4., 7.), 0.25 * 3., 1e-12);
}

TEST(RemainingTime, WhatTheSolverDoesNotKnowIsNotKnown)
{
  RemainingTime remaining;
  remaining.set_forecast({{5., std::nan("")}});
  remaining.add(0.5, 100., 25.);
  EXPECT_TRUE(std::isnan(remaining.left(0., 5.)));
}

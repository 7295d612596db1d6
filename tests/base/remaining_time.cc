// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/remaining_time.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;

TEST(RemainingTime, UniformRunsAreKnownFromTheirFirstStep)
{
  RemainingTime remaining(1., 3.);
  EXPECT_TRUE(std::isinf(remaining.left()));
  for (unsigned int i = 1; i <= 20000; ++i)
  {
    remaining.add(1. + 1e-4 * i, 0.02 * i);
    ASSERT_NEAR(remaining.left(), 400. - 0.02 * i, 1e-6) << i;
  }
}

// A tenth of the time for nothing, the rest dear.
TEST(RemainingTime, WhatARunCostsLatelyCounts)
{
  RemainingTime remaining(0., 1.);
  for (unsigned int i = 1; i < 1000; ++i)
  {
    const double cost = i <= 100 ? 1e-3 * i : 1. * (i - 100);
    remaining.add(1e-3 * i, cost);
    if (cost > 90.)
      ASSERT_NEAR(remaining.left(), 900. - cost, 1e-2 * (900. - cost)) << i;
  }
}

// The second half costs nine times the first: linear in time the rest would be
// wrong by that factor. The run is three times as slow as its course.
TEST(RemainingTime, FollowsTheCourse)
{
  RemainingTime remaining(0., 2., {{0., 0.}, {1., 1.}, {2., 10.}});
  EXPECT_NEAR(remaining.left(), 10., 1e-12);
  remaining.add(1., 3.);
  EXPECT_NEAR(remaining.left(), 27., 0.2 * 27.);
  remaining.add(1.5, 16.5);
  EXPECT_NEAR(remaining.left(), 13.5, 0.02 * 13.5);
  remaining.add(2., 30.);
  EXPECT_EQ(remaining.left(), 0.);
}

// A run that goes on from the middle has not yet cost what came before.
TEST(RemainingTime, FollowsTheRestOfACourse)
{
  RemainingTime remaining(1., 2., {{0., 0.}, {1., 100.}, {2., 110.}});
  remaining.add(1.5, 5.);
  EXPECT_NEAR(remaining.left(), 5., 1e-12);
}

TEST(RemainingTime, CoursesThatTellNothingAreNone)
{
  for (const ExpectedCourse &course :
       {ExpectedCourse{{0., 1.}}, ExpectedCourse{{0., 1.}, {2., 1.}}})
  {
    RemainingTime remaining(0., 2., course);
    remaining.add(1., 5.);
    EXPECT_DOUBLE_EQ(remaining.left(), 5.);
  }
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/first_stage/front_path.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup::coupling;

TEST(FrontPath, KnowsNothingBeforeItsSecondJump)
{
  FrontPath path;
  EXPECT_TRUE(std::isnan(path.arrival(1.)));
  path.add(1e-3, 0.3);
  path.add(2e-3, 0.3);
  EXPECT_TRUE(std::isnan(path.arrival(1.)));
  path.add(3e-3, 0.4);
  EXPECT_FALSE(std::isnan(path.arrival(1.)));
}

// r = 2 t^0.6, seen when it enters the next cell of 10 mm.
TEST(FrontPath, GoesOnAlongAPowerOfTime)
{
  FrontPath path;
  const auto distance = [](const double time) {
    return 0.01 * std::floor(200. * std::pow(time, 0.6));
  };
  for (unsigned int step = 1; step <= 1000; ++step)
    path.add(1e-6 * step, distance(1e-6 * step));
  const double arrival = std::pow(0.5 * 0.1, 1. / 0.6);
  EXPECT_NEAR(path.arrival(0.1), arrival, 0.02 * arrival);
}

// A front that stands still for long, or starts at once, is none of a blast.
TEST(FrontPath, KeepsToExponentsOfBlasts)
{
  FrontPath slow, fast;
  for (unsigned int i = 1; i <= 10; ++i)
  {
    slow.add(1e-3 * i, 1. + 1e-3 * i);
    fast.add(1e-3 * i, 0.1 * std::pow(i, 3));
  }
  EXPECT_NEAR(slow.arrival(2.02), 0.01 * std::pow(2., 2.5), 1e-12);
  EXPECT_NEAR(fast.arrival(200.), 0.02, 1e-12);
}

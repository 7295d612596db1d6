// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/study/pareto.h>

#include <gtest/gtest.h>

using namespace contrecoup::study;

namespace
{
const double nan = std::nan("");
const std::vector<double> costs = {1., 2., 3., 2., 4., nan, 0.5};
const std::vector<double> errors = {9., 5., 6., 5., 1., 0., nan};
} // namespace

TEST(Pareto, KeepsWhatNothingBeats)
{
  // Equal ones stay both; what has no number is never on the front.
  EXPECT_EQ(pareto_front(costs, errors),
            (std::vector<bool>{true, true, false, true, true, false, false}));
  EXPECT_TRUE(pareto_front({}, {}).empty());
}

TEST(Pareto, CheapestMeetsTheWantedError)
{
  EXPECT_EQ(cheapest(costs, errors, 5.), 1u);
  EXPECT_EQ(cheapest(costs, errors, 4.9), 4u);
  EXPECT_EQ(cheapest(costs, errors, 100.), 0u);
  EXPECT_FALSE(cheapest(costs, errors, 0.5).has_value());
}

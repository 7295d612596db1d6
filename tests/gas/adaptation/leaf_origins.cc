// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation/leaf_origins.h>

#include <gtest/gtest.h>

#include <stdexcept>

using namespace contrecoup::gas;
using Levels = std::vector<unsigned char>;
using Change = LeafOrigin::Change;

namespace
{
void expect_origin(const LeafOrigin &origin,
                   const unsigned int former,
                   const Change change,
                   const unsigned int child = 0)
{
  EXPECT_EQ(origin.former, former);
  EXPECT_EQ(origin.change, change);
  EXPECT_EQ(origin.child, child);
}
} // namespace


TEST(LeafOrigins, LeavesThatStayKeepTheirOrder)
{
  const Levels levels = {1, 2, 2, 2, 2, 1, 1};
  const auto origins = leaf_origins<2>(levels, levels);
  ASSERT_EQ(origins.size(), levels.size());
  for (unsigned int leaf = 0; leaf < levels.size(); ++leaf)
    expect_origin(origins[leaf], leaf, Change::none);
}


// A refined leaf next to merged ones: as many leaves of the same levels, at
// other places.
TEST(LeafOrigins, RefinedAndMergedLeavesAreToldApart)
{
  const auto origins =
    leaf_origins<2>({1, 2, 2, 2, 2, 1, 1}, {2, 2, 2, 2, 1, 1, 1});
  ASSERT_EQ(origins.size(), 7U);
  for (unsigned int child = 0; child < 4; ++child)
    expect_origin(origins[child], 0, Change::refined, child);
  expect_origin(origins[4], 1, Change::merged);
  expect_origin(origins[5], 5, Change::none);
  expect_origin(origins[6], 6, Change::none);
}


TEST(LeafOrigins, ALineHasTwoChildren)
{
  const auto origins = leaf_origins<1>({0, 2, 2, 1}, {0, 1, 2, 2});
  ASSERT_EQ(origins.size(), 4U);
  expect_origin(origins[0], 0, Change::none);
  expect_origin(origins[1], 1, Change::merged);
  expect_origin(origins[2], 3, Change::refined, 0);
  expect_origin(origins[3], 3, Change::refined, 1);
}


TEST(LeafOrigins, OtherRegionsAndJumpsOfTwoLevelsAreRefused)
{
  EXPECT_THROW(leaf_origins<2>({1, 1, 1, 1}, {1, 1, 1}), std::logic_error);
  EXPECT_THROW(leaf_origins<2>({1, 1, 1}, {1, 1, 1, 1}), std::logic_error);
  EXPECT_THROW(leaf_origins<1>({0}, {2, 2, 2, 2}), std::logic_error);
  EXPECT_THROW(leaf_origins<3>({1}, {2, 2, 2, 2}), std::logic_error);
}

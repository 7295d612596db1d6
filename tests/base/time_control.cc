// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/run/time_control.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace contrecoup;

namespace
{
/// Runs a solver whose own step is @p own and returns all step sizes.
std::vector<double>
step_sizes(const TimeControl &control, const double own, RunState &state)
{
  std::vector<double> sizes;
  control.set_ticks(state);
  while (!control.finished(state))
  {
    const double bound = control.bound(state);
    const double step = std::min(own, bound);
    control.after_step(state, state.time + step, step, bound);
    sizes.push_back(step);
    control.set_ticks(state);
  }
  return sizes;
}
} // namespace

TEST(TimeControl, SharesWhatRemainsBetweenTheLastTwoSteps)
{
  TimeParameters parameters;
  parameters.end_time = 1.05;
  RunState state;
  const auto sizes = step_sizes(TimeControl(parameters), 0.1, state);
  EXPECT_EQ(state.time, 1.05);
  ASSERT_EQ(sizes.size(), 11u);
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_EQ(sizes[i], 0.1);
  EXPECT_NEAR(sizes[9], 0.075, 1e-15);
  EXPECT_NEAR(sizes[10], 0.075, 1e-15);
}

TEST(TimeControl, MeetsEveryOutputTimeExactly)
{
  TimeParameters parameters;
  parameters.end_time = 1e-3;
  parameters.fields_interval = 1e-4;
  parameters.history_interval = 3e-5;
  const TimeControl control(parameters);
  RunState state;
  control.set_ticks(state);
  std::vector<double> fields, rows;
  double smallest = 1.;
  while (!control.finished(state))
  {
    const double bound = control.bound(state);
    const double step = std::min(7e-6, bound);
    smallest = std::min(smallest, step);
    control.after_step(state, state.time + step, step, bound);
    if (control.fields_due(state))
      fields.push_back(state.time);
    if (control.history_due(state))
      rows.push_back(state.time);
    control.set_ticks(state);
  }
  ASSERT_EQ(fields.size(), 10u);
  ASSERT_EQ(rows.size(), 33u);
  for (std::size_t i = 0; i < fields.size(); ++i)
    EXPECT_DOUBLE_EQ(fields[i], (i + 1) * 1e-4);
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_DOUBLE_EQ(rows[i], (i + 1) * 3e-5);
  EXPECT_GT(smallest, 3e-6);
}

TEST(TimeControl, StepsFollowFromTheStateAlone)
{
  TimeParameters parameters;
  parameters.end_time = 1.;
  parameters.fields_interval = 0.13;
  RunState straight;
  const auto all = step_sizes(TimeControl(parameters), 0.0317, straight);

  parameters.largest_number_of_steps = all.size() / 2 + 1;
  RunState resumed;
  auto sizes = step_sizes(TimeControl(parameters), 0.0317, resumed);
  ASSERT_LT(sizes.size(), all.size());
  parameters.largest_number_of_steps = 0;
  const auto rest = step_sizes(TimeControl(parameters), 0.0317, resumed);
  sizes.insert(sizes.end(), rest.begin(), rest.end());
  EXPECT_EQ(sizes, all);
  EXPECT_EQ(resumed.time, straight.time);
}

TEST(TimeControl, BoundsSteps)
{
  TimeParameters parameters;
  parameters.end_time = 1.;
  parameters.largest_step = 0.25;
  RunState state;
  EXPECT_EQ(step_sizes(TimeControl(parameters), 1., state),
            std::vector<double>(4, 0.25));
}

TEST(TimeControl, StepsLongerThanTheIntervalStillMeetEachTick)
{
  TimeParameters parameters;
  parameters.end_time = 1.;
  parameters.history_interval = 0.125;
  RunState state;
  EXPECT_EQ(step_sizes(TimeControl(parameters), 10., state),
            std::vector<double>(8, 0.125));
}

TEST(TimeControl, NothingToDoAtOrAfterTheEnd)
{
  TimeParameters parameters;
  parameters.end_time = 0.;
  RunState state;
  EXPECT_TRUE(step_sizes(TimeControl(parameters), 1., state).empty());
}

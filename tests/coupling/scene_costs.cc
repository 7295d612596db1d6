// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/memory.h>
#include <contrecoup/coupling/scene/scene_costs.h>
#include <contrecoup/io/file/temporary_folder.h>

#include <gtest/gtest.h>

#include <vector>

using namespace contrecoup;
using namespace contrecoup::coupling;

// All stages begin after the forecasts, and with what these keep.
TEST(SceneCosts, HaveTheMemoryThatForecastsKeep)
{
  const io::TemporaryFolder folder;
  Collective collective(MPI_COMM_WORLD);
  std::vector<char> kept;
  std::vector<SceneTask> tasks;
  const auto add = [&](const std::string &name, const double memory) {
    const auto runner = [&kept,
                         memory](const auto &, double, CostEstimate &cost) {
      kept.assign(kept.size() + 20'000'000, 1);
      cost.memory = memory;
      return Failure();
    };
    tasks.emplace_back(
      TaskDescription{name, name, folder.path(), "", {}, {}, runner});
  };
  add("anatomy", 1.);
  add("blast", 0.);
  add("biomechanics", 1e12);
  forget_peak_memory();
  const double before = peak_memory(MPI_COMM_SELF);
  const StageCosts costs = estimate_costs(tasks, 0., false, collective);
  ASSERT_EQ(costs.size(), 3U);
  EXPECT_GT(costs[0].second.memory, before + 0.5 * kept.size());
  EXPECT_EQ(costs[1].second.memory, 0.);
  EXPECT_EQ(costs[2].second.memory, 1e12);
}

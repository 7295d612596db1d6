// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/application/anatomy_application.h>
#include <contrecoup/io/file/temporary_folder.h>

#include <gtest/gtest.h>

#include <fstream>
#include <vector>

using namespace contrecoup;

// Of a stage of a scene, the memory that the scene has already is part.
TEST(AnatomyForecast, HasTheMemoryOfItsProcess)
{
  const io::TemporaryFolder folder;
  const std::string file = folder.path() + "/body.prm";
  std::ofstream(file) << "";
  const std::vector<char> others(400'000'000, 1);
  CostEstimate cost;
  const Failure failure = io::run_within(
    {"anatomy", file, "--check", "--set", "Mesh/Element size=0.04"},
    coupling::anatomy_application(
      [&cost](const CostEstimate &found) { cost = found; }));
  EXPECT_EQ(failure.code, ExitCode::done) << failure.message;
  EXPECT_GT(cost.cells, 100.);
  EXPECT_GT(cost.memory, others.size());
}

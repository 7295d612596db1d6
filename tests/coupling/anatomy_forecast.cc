// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/application/anatomy_application.h>
#include <contrecoup/io/file/temporary_folder.h>

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

using namespace contrecoup;

namespace
{
/// Forecast of the phantom with some entries.
CostEstimate forecast(const std::vector<std::string> &entries)
{
  const io::TemporaryFolder folder;
  const std::string file = folder.path() + "/body.prm";
  std::ofstream(file) << "";
  std::vector<std::string> words{"anatomy", file, "--check"};
  for (const std::string &entry : entries)
    words.insert(words.end(), {"--set", entry});
  CostEstimate cost;
  const Failure failure = io::run_within(
    words, coupling::anatomy_application([&cost](const CostEstimate &found) {
      cost = found;
    }));
  EXPECT_EQ(failure.code, ExitCode::done) << failure.message;
  return cost;
}
} // namespace

// The forecast of a stage includes the memory that its scene holds already.
TEST(AnatomyForecast, HasTheMemoryOfItsProcess)
{
  const std::vector<char> others(400'000'000, 1);
  const CostEstimate cost = forecast({"Mesh/Element size=0.04"});
  EXPECT_GT(cost.cells, 100.);
  EXPECT_GT(cost.memory, others.size());
}

// Positions before and after, and sums: 81 bytes of a node while it is
// smoothed, as the numbers of the grid's nodes are gone by then.
TEST(AnatomyForecast, HasTheMemoryOfSmoothing)
{
  const std::string size = "Mesh/Element size=0.01";
  forecast({size}); // what the first one takes of the process
  const CostEstimate smooth = forecast({size, "Mesh/Smoothing iterations=5"}),
                     plain = forecast({size});
  EXPECT_EQ(smooth.cells, plain.cells);
  EXPECT_GT(smooth.memory, plain.memory + 20. * plain.cells);
}

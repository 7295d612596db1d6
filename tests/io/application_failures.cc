// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "harness.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace contrecoup::io;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace
{
/// Expects an exit code and one line on stderr of the first rank only.
void expect_failure(const Result &result,
                    const int code,
                    const std::string &message)
{
  EXPECT_EQ(result.code, code);
  if (!is_first_rank())
  {
    EXPECT_EQ(result.err, "");
    return;
  }
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1)
    << result.err;
  EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
}

std::vector<std::string>
with(const std::string &kind, const int step, const int rank = -1)
{
  return {"--set",
          "Mishap/Kind=" + kind,
          "--set",
          "Mishap/Step=" + std::to_string(step),
          "--set",
          "Mishap/Rank=" + std::to_string(rank)};
}

std::string status(const std::string &folder)
{
  return Json::parse(content(folder + "/summary.json"))["status"];
}

/// Checkpoint folders, sorted.
std::vector<std::string> checkpoints(const std::string &folder)
{
  std::vector<std::string> names;
  if (exists(folder + "/checkpoint"))
    for (const auto &item : fs::directory_iterator(folder + "/checkpoint"))
      names.push_back(item.path().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// Starts a run that stops with two checkpoints.
void stop_with_checkpoints(const std::string &folder)
{
  remove(folder);
  ASSERT_EQ(run_scene(folder,
                      {"--set",
                       "Time/Steps in this run=20",
                       "--set",
                       "Output/Checkpoint every steps=8"})
              .code,
            0);
  ASSERT_EQ(checkpoints(folder).size(), 2u);
}

void truncate(const std::string &file, const std::size_t n_bytes)
{
  if (is_first_rank())
    fs::resize_file(file, n_bytes);
  MPI_Barrier(MPI_COMM_WORLD);
}
} // namespace

TEST(BadInput, IsRefusedInOneLineAndLeavesNothing)
{
  const std::string folder = local("refused");
  remove(folder);
  expect_failure(run_oscillator({}), 1, "no parameter file");
  expect_failure(run_oscillator({"nowhere.prm"}), 1, "\"nowhere.prm\"");
  expect_failure(run_scene(folder, {"--chek"}), 1, "did you mean \"--check\"");
  expect_failure(run_scene(folder, {"--set", "Oscillator/Mas=1"}),
                 1,
                 "did you mean \"Mass\"");
  expect_failure(run_scene(folder, {"--set", "Oscillator/Mass=-1"}),
                 1,
                 "a number of at least 1e-300");
  expect_failure(
    run_scene(folder, {"--set", "Oscillator/Cells=1e15"}), 1, "of memory");
  expect_failure(
    run_scene(folder, {"--check", "--set", "Oscillator/Cells=1e15"}),
    1,
    "of memory");
  expect_failure(run_scene(folder, with("input", 0)), 1, "spring is broken");
  EXPECT_FALSE(exists(folder));
  // A run that left nothing begins.
  EXPECT_EQ(run_scene(folder, {"--resume"}).code, 0);
  expect_failure(run_scene(folder, {"--resume", "--set", "Time/End time=4"}),
                 1,
                 "Output/Checkpoint at the end = true");
}

TEST(BadInput, OfOneRankIsThatOfAll)
{
  const std::string folder = local("one_rank");
  remove(folder);
  expect_failure(
    run_scene(folder, with("input", 0, n_ranks() - 1)), 1, "spring is broken");
  EXPECT_FALSE(exists(folder));
}

TEST(BadInput, UnwritableOutputFolder)
{
  const std::string file = local("a_file");
  if (is_first_rank())
    std::ofstream(file) << "in the way\n";
  MPI_Barrier(MPI_COMM_WORLD);
  expect_failure(run_scene(file), 1, "output folder");
  expect_failure(run_scene(file + "/below"), 1, "output folder");
  EXPECT_EQ(content(file), "in the way\n");
}

TEST(BadInput, CheckpointOfAnotherScene)
{
  const std::string folder = local("foreign");
  stop_with_checkpoints(folder);
  const std::string before = content(folder + "/history.csv");
  expect_failure(run_scene(folder, {"--resume", "--set", "Oscillator/Mass=2"}),
                 1,
                 "\"Oscillator/Mass\" was \"1\" and is now \"2\"");
  EXPECT_EQ(content(folder + "/history.csv"), before);
}

TEST(BadInput, DamagedCheckpointGivesWayToTheOneBefore)
{
  const std::string folder = local("damaged");
  stop_with_checkpoints(folder);
  truncate(checkpoints(folder)[1] + "/oscillator.bin", 10);
  const Result result = run_scene(folder, {"--resume"});
  EXPECT_EQ(result.code, 0);
  if (is_first_rank())
  {
    EXPECT_NE(result.out.find("\"oscillator.bin\" has 10 bytes"),
              std::string::npos);
    EXPECT_NE(result.out.find("step 16,"), std::string::npos);
  }
  const std::string straight = local("straight_beside_damaged");
  remove(straight);
  run_scene(straight);
  EXPECT_EQ(content(straight + "/history.csv"),
            content(folder + "/history.csv"));
}

TEST(BadInput, AllCheckpointsDamaged)
{
  const std::string folder = local("all_damaged");
  stop_with_checkpoints(folder);
  const std::string before = content(folder + "/history.csv");
  const auto found = checkpoints(folder);
  truncate(found[0] + "/complete.json", 5);
  // Same length, other content.
  if (is_first_rank())
  {
    std::fstream file(found[1] + "/oscillator.bin");
    file.seekp(50000);
    file << "!";
  }
  MPI_Barrier(MPI_COMM_WORLD);
  expect_failure(run_scene(folder, {"--resume"}),
                 1,
                 "content of the file \"oscillator.bin\" is damaged");
  EXPECT_EQ(content(folder + "/history.csv"), before);
}

TEST(BadInput, HistoryThatIsGoneCannotBeResumed)
{
  const std::string folder = local("gone");
  stop_with_checkpoints(folder);
  truncate(folder + "/history.csv", 30);
  expect_failure(run_scene(folder, {"--resume"}), 1, "history.csv");
}

TEST(Numerics, FailureWritesTheStateAndKeepsTheCheckpoint)
{
  const std::string folder = local("numerics");
  for (const char *kind : {"numerics", "no progress", "not a number"})
  {
    remove(folder);
    auto arguments = with(kind, 12);
    arguments.insert(arguments.end(),
                     {"--set", "Output/Checkpoint every steps=5"});
    const Result result = run_scene(folder, arguments);
    EXPECT_EQ(result.code, 2) << kind;
    expect_failure(result, 2, "");
    EXPECT_EQ(status(folder), "failed");
    EXPECT_EQ(checkpoints(folder).size(), 2u);
    const std::string end = n_ranks() > 1 ? ".pvtu" : ".vtu";
    EXPECT_TRUE(exists(folder + "/fields/oscillator_0001" + end)) << kind;
  }
  EXPECT_EQ(run_scene(folder, {"--resume"}).code, 0);
  EXPECT_EQ(status(folder), "finished");
}

TEST(Numerics, FailureOfOneRankIsThatOfAll)
{
  const std::string folder = local("numerics_one_rank");
  remove(folder);
  expect_failure(run_scene(folder, with("numerics", 3, n_ranks() - 1)),
                 2,
                 "the mass left the room");
  EXPECT_EQ(status(folder), "failed");
}

TEST(System, OutOfMemoryGivesThree)
{
  const std::string folder = local("memory");
  remove(folder);
  expect_failure(
    run_scene(folder, with("memory", 3, n_ranks() - 1)), 3, "out of memory");
}

TEST(System, DealIIErrorsAreOneLine)
{
  const std::string folder = local("deal_ii");
  remove(folder);
  expect_failure(run_scene(folder, with("deal.II", 3)), 2, "an assertion");
}

TEST(System, FullDiskDuringACheckpointKeepsTheLast)
{
  const std::string straight = local("straight_beside_full");
  const std::string folder = local("full");
  remove(straight);
  run_scene(straight);
  stop_with_checkpoints(folder);
  const auto before = checkpoints(folder);
  {
    const FullDisk disk(50000);
    expect_failure(
      run_scene(folder,
                {"--resume", "--set", "Output/Checkpoint every steps=3"}),
      3,
      "File too large");
  }
  EXPECT_EQ(checkpoints(folder), before);
  EXPECT_EQ(run_scene(folder, {"--resume"}).code, 0);
  EXPECT_EQ(content(straight + "/history.csv"),
            content(folder + "/history.csv"));
}

TEST(System, FullDiskDuringHistoryOrFields)
{
  const std::string folder = local("full_at_once");
  remove(folder);
  // Room for the manifest and the parameters, not for a thousand rows.
  const FullDisk disk(12000);
  expect_failure(
    run_scene(folder, {"--set", "Time/End time=100"}), 3, "cannot write");
  EXPECT_TRUE(exists(folder + "/manifest.json"));
  EXPECT_TRUE(exists(folder + "/parameters.prm"));
  for (const auto &item : fs::recursive_directory_iterator(folder))
    EXPECT_EQ(item.path().string().find(".partial"), std::string::npos);
}

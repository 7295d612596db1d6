// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/output/checkpoint.h>
#include <contrecoup/io/run/run_description.h>

#include <gtest/gtest.h>

#include <filesystem>

using namespace contrecoup;
using namespace contrecoup::io;
namespace fs = std::filesystem;

namespace
{
unsigned int rank()
{
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
}

/// Every rank writes a file of its own.
void save(const std::string &folder)
{
  write_file(folder + "/rank_" + std::to_string(rank()) + ".bin",
             [](std::ostream &out) { out << "state"; });
}

/// A folder for this number of ranks, empty.
std::string fresh(const std::string &name)
{
  const std::string folder =
    name + "_" +
    std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
  if (rank() == 0)
    fs::remove_all(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  return folder;
}

std::vector<std::string> names(const std::string &folder)
{
  MPI_Barrier(MPI_COMM_WORLD);
  std::vector<std::string> found;
  for (const auto &item : fs::directory_iterator(folder))
    found.push_back(item.path().filename().string());
  std::sort(found.begin(), found.end());
  MPI_Barrier(MPI_COMM_WORLD);
  return found;
}
} // namespace

TEST(Checkpoints, TheLastTwoAreKept)
{
  Collective collective(MPI_COMM_WORLD);
  const std::string folder = fresh("kept");
  Checkpoints checkpoints(folder, collective);
  EXPECT_FALSE(checkpoints.newest());
  for (const char *run : {"a", "b", "c"})
    checkpoints.write(run, save);
  EXPECT_EQ(names(folder), (std::vector<std::string>{"0002", "0003"}));
  const auto found = checkpoints.newest();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->run, "c");
  EXPECT_EQ(found->folder, folder + "/0003");
  EXPECT_EQ(
    read_file(found->folder + "/rank_" + std::to_string(rank()) + ".bin"),
    "state");
}

TEST(Checkpoints, AFailureOfOneRankLeavesNothing)
{
  Collective collective(MPI_COMM_WORLD);
  const std::string folder = fresh("failing");
  Checkpoints checkpoints(folder, collective);
  checkpoints.write("a", save);
  const unsigned int last =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
  EXPECT_THROW(checkpoints.write("b",
                                 [&](const std::string &path) {
                                   save(path);
                                   if (rank() == last)
                                     throw SystemError("disk full");
                                 }),
               SystemError);
  EXPECT_EQ(names(folder), std::vector<std::string>{"0001"});
}

TEST(Checkpoints, WithoutItsMarkerOneDoesNotCount)
{
  Collective collective(MPI_COMM_WORLD);
  const std::string folder = fresh("unmarked");
  Checkpoints checkpoints(folder, collective);
  checkpoints.write("a", save);
  checkpoints.write("b", save);
  if (rank() == 0)
    fs::remove(folder + "/0002/complete.json");
  EXPECT_EQ(checkpoints.newest()->run, "a");
  checkpoints.write("c", save);
  EXPECT_EQ(names(folder), (std::vector<std::string>{"0001", "0003"}));
}

TEST(RunDescription, ComesBackBitByBit)
{
  RunDescription description;
  description.application = "oscillator";
  description.state.step = 123456789012ull;
  description.state.time = 1. / 3.;
  description.state.unbounded_step = 1e-310;
  description.history_bytes = 77;
  description.fields = {{0.1, "skin", "fields/a.vtp"}};
  description.first_values = {{"mass", "kg", 2. / 3., true}};
  description.parameters = {{"A/B", "\"quoted\"\\"}};
  const RunDescription again = from_text(to_text(description));
  EXPECT_EQ(again.application, "oscillator");
  EXPECT_EQ(again.state.step, 123456789012ull);
  EXPECT_EQ(again.state.time, 1. / 3.);
  EXPECT_EQ(again.state.unbounded_step, 1e-310);
  EXPECT_EQ(again.state.history_step, -1);
  EXPECT_EQ(again.history_bytes, 77u);
  ASSERT_EQ(again.fields.size(), 1U);
  EXPECT_EQ(again.fields[0].time, 0.1);
  EXPECT_EQ(again.fields[0].part, "skin");
  EXPECT_EQ(again.fields[0].file, "fields/a.vtp");
  EXPECT_EQ(again.first_values.at(0).value, 2. / 3.);
  EXPECT_TRUE(again.first_values.at(0).conserved);
  EXPECT_EQ(again.parameters, description.parameters);
  EXPECT_THROW(from_text("{}"), InputError);
  EXPECT_THROW(from_text("{"), InputError);
  EXPECT_EQ(again.build, this_build());
}

TEST(RunDescription, AnotherFormatIsRefusedWithBothBuilds)
{
  const std::string text = to_text({});
  for (const char *const other :
       {"\"format\": 0", "\"format\": \"1\"", "\"x\": 1"})
  {
    std::string changed = text;
    const std::string format =
      "\"format\": " + std::to_string(formats::checkpoint.number);
    changed.replace(changed.find(format), format.size(), other);
    const std::string release = "\"version\": \"";
    changed.insert(changed.find(release) + release.size(), "7.");
    try
    {
      from_text(changed);
      ADD_FAILURE() << other;
    }
    catch (const InputError &error)
    {
      const std::string message = error.what();
      EXPECT_NE(message.find("written by 7." + this_build()), std::string::npos)
        << message;
      EXPECT_NE(message.find("this is " + this_build()), std::string::npos)
        << message;
    }
  }
}

TEST(RunDescription, ScenesDifferInWhatIsNotExempt)
{
  using Entries = std::map<std::string, std::string>;
  const Entries before = {{"Time/End", "1"}, {"Out/A", "1"}, {"Gas/G", "1.4"}};
  const std::vector<std::string> exempt = {"Time/End", "Out/"};
  const Entries later = {{"Time/End", "2"}, {"Out/B", "1"}, {"Gas/G", "1.4"}};
  EXPECT_NO_THROW(require_same_scene(before, later, exempt));
  EXPECT_THROW(require_same_scene(before, later, {"Out/"}), InputError);
  EXPECT_THROW(require_same_scene(before, {{"Gas/G", "1.6"}}, exempt),
               InputError);
  EXPECT_THROW(require_same_scene(before, {}, exempt), InputError);
  EXPECT_THROW(require_same_scene({}, before, exempt), InputError);
}

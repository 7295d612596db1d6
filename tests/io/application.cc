// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/signals.h>
#include <contrecoup/io/application/application.h>
#include <contrecoup/io/application/run_entries.h>

#include "harness.h"
#include "oscillator.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <utility>

using namespace contrecoup::io;
using Json = nlohmann::json;

namespace
{
Json summary(const std::string &folder)
{
  return Json::parse(content(folder + "/summary.json"));
}

std::ptrdiff_t n_lines(const std::string &text)
{
  return std::count(text.begin(), text.end(), '\n');
}

void expect_same_results(const std::string &one, const std::string &two)
{
  for (const char *name : {"history.csv", "probes.csv"})
  {
    EXPECT_GT(n_lines(content(one + "/" + name)), 40) << name;
    EXPECT_EQ(content(one + "/" + name), content(two + "/" + name)) << name;
  }
  EXPECT_EQ(summary(one)["conservation"], summary(two)["conservation"]);
  EXPECT_EQ(summary(one)["errors"], summary(two)["errors"]);
  const auto listed = [](const std::string &folder) {
    const std::string text = content(folder + "/fields.pvd");
    return text.substr(text.find("<Collection>"));
  };
  EXPECT_EQ(listed(one), listed(two));
}

int signal_at_start = 0;
} // namespace

/// With a signal that comes as MPI starts.
int MPI_Initialized(int *flag)
{
  if (const int asked = std::exchange(signal_at_start, 0))
    std::raise(asked);
  return PMPI_Initialized(flag);
}

TEST(Application, EndsBySignalsBeforeTheStart)
{
  for (const auto &[asked, name] : {std::pair{SIGINT, "SIGINT"},
                                    {SIGTERM, "SIGTERM"},
                                    {SIGUSR1, "SIGUSR1"}})
  {
    std::string program = "oscillator";
    char *argv[] = {program.data(), nullptr};
    bool has_started = false;
    signal_at_start = asked;
    testing::internal::CaptureStdout();
    const int code =
      run_with_mpi(1, argv, [&](const std::vector<std::string> &) {
        has_started = true;
        return contrecoup::Failure();
      });
    EXPECT_EQ(testing::internal::GetCapturedStdout(),
              is_first_rank() ? std::string("asked to stop by ") + name +
                                  " before the start\n"
                              : "");
    EXPECT_EQ(code, 128 + asked);
    EXPECT_FALSE(has_started);
  }
  const contrecoup::SignalGuard forgets_the_signal;
}

TEST(Application, ScreenIsShortUnlessVerbose)
{
  const std::string folder = local("quiet");
  remove(folder);
  const Result result = run_oscillator({scene(), "--output", folder}, false);
  EXPECT_EQ(result.code, 0);
  const std::string log = content(folder + "/log.txt");
  EXPECT_NE(log.find("advance"), std::string::npos) << "has no timers";
  EXPECT_EQ(result.out.find("advance"), std::string::npos);
  if (!is_first_rank())
    return;
  EXPECT_LT(n_lines(result.out), 10);
  EXPECT_EQ(result.out.find("oscillator "), 0U);
  EXPECT_NE(result.out.find("\nfinished at step "), std::string::npos);
  EXPECT_NE(result.out.find("\nresults in " + folder), std::string::npos);
}

TEST(Application, RunsEntriesThatAProgramSets)
{
  const std::string by_file = local("by_file"),
                    by_entries = local("by_entries");
  remove(by_file);
  remove(by_entries);
  EXPECT_EQ(run_scene(by_file).code, 0);

  const ApplicationDescription oscillator = oscillator_application();
  dealii::ParameterHandler prm;
  declare_entries(oscillator, prm);
  prm.parse_input(scene());
  CommandLine command;
  command.output_folder = by_entries;
  EXPECT_EQ(run_entries(command, prm, oscillator).message, "");
  expect_same_results(by_file, by_entries);
}

TEST(Application, LeavesTheFilesOfTheContract)
{
  const std::string folder = local("plain");
  remove(folder);
  const Result result = run_scene(folder);
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  if (is_first_rank())
    EXPECT_EQ(content(folder + "/log.txt"), result.out);
  else
    EXPECT_EQ(result.out, "");

  const std::string history = content(folder + "/history.csv");
  EXPECT_EQ(history.substr(0, history.find('\n')),
            "step,time [s],step size [s],mass [kg],position [m],energy [J]");
  EXPECT_NE(history.find("\n0,0,0,1,1,0.5\n"), std::string::npos);
  const std::string probes = content(folder + "/probes.csv");
  EXPECT_EQ(probes.substr(0, probes.find('\n')),
            "time [s],mass position [m],mass velocity [m/s]");

  const Json json = summary(folder);
  EXPECT_EQ(json["application"], "oscillator");
  EXPECT_EQ(json["status"], "finished");
  EXPECT_EQ(json["ranks"], n_ranks());
  EXPECT_EQ(json["steps"].get<int>() + 2, n_lines(history));
  EXPECT_EQ(json["time"], 3.3);
  EXPECT_EQ(json["conservation"]["mass_relative_change"], 0.);
  EXPECT_EQ(json["conservation"]["energy_first"], 0.5);
  EXPECT_LT(
    std::abs(json["conservation"]["energy_relative_change"].get<double>()),
    0.1);
  EXPECT_FALSE(json["conservation"].contains("position_first"));
  EXPECT_LT(json["errors"]["position"].get<double>(), 0.1);
  EXPECT_TRUE(json["checks"]["largest_angle"]["value"].is_null());
  EXPECT_GT(json["performance"]["updates_per_second_per_core"], 0.);
  EXPECT_GT(json["performance"]["peak_memory_bytes"], 1e6);
  EXPECT_TRUE(json["timers"].contains("advance"));
}

TEST(Application, FieldsAreListedWithTheirTimes)
{
  const std::string folder = local("plain");
  run_scene(folder);
  const std::string list = content(folder + "/fields.pvd");
  const std::string end = n_ranks() > 1 ? "pvtu" : "vtu";
  const char *const times[] = {"0", "1", "2", "3", "3.3"};
  for (int i = 0; i < 5; ++i)
  {
    const std::string file =
      "fields/oscillator_000" + std::to_string(i) + "." + end;
    EXPECT_TRUE(exists(folder + "/" + file));
    EXPECT_NE(list.find("timestep=\"" + std::string(times[i]) +
                        "\" group=\"\" part=\"0\" file=\"" + file),
              std::string::npos)
      << list;
  }
}

TEST(Application, FieldsCanBeHdf5)
{
  const std::string folder = local("hdf5");
  remove(folder);
  EXPECT_EQ(run_scene(folder, {"--set", "Output/Field format=hdf5"}).code, 0);
  EXPECT_TRUE(exists(folder + "/fields/oscillator_0004.h5"));
  EXPECT_TRUE(exists(folder + "/fields/oscillator_0004.xdmf"));
  EXPECT_FALSE(exists(folder + "/fields.pvd"));
}

TEST(Application, WrittenParametersGiveTheSameRun)
{
  const std::string one = local("first"), two = local("again");
  remove(one);
  remove(two);
  run_scene(one, {"--set", "Oscillator/Damping=0.12345678901234567"});
  EXPECT_EQ(run_oscillator({one + "/parameters.prm", "--output", two}).code, 0);
  expect_same_results(one, two);
}

TEST(Application, OverridesWinOverTheFile)
{
  const std::string folder = local("override");
  remove(folder);
  EXPECT_EQ(run_scene(folder,
                      {"--set",
                       "Time/End time=2",
                       "--set=Time/End time = 0.25",
                       "--set",
                       "Output/History interval=0.1"})
              .code,
            0);
  EXPECT_EQ(summary(folder)["time"], 0.25);
  EXPECT_EQ(n_lines(content(folder + "/history.csv")), 5);
}

TEST(Application, StopAndResumeEqualsStraightThrough)
{
  const std::string straight = local("straight"), parts = local("parts");
  remove(straight);
  remove(parts);
  EXPECT_EQ(run_scene(straight).code, 0);
  EXPECT_EQ(run_scene(parts, {"--set", "Time/Steps in this run=17"}).code, 0);
  EXPECT_EQ(summary(parts)["status"], "stopped");
  EXPECT_EQ(run_scene(parts,
                      {"--resume",
                       "--set",
                       "Time/Steps in this run=11",
                       "--set",
                       "Output/Checkpoint every steps=3"})
              .code,
            0);
  // Rows and fields after the checkpoint must vanish on resume.
  if (is_first_rank())
    for (const char *name : {"/history.csv", "/probes.csv"})
    {
      std::FILE *file = std::fopen((parts + name).c_str(), "a");
      std::fputs("99,99,99,99,99,99\n", file);
      std::fclose(file);
    }
  EXPECT_EQ(run_scene(parts, {"--resume"}).code, 0);
  EXPECT_EQ(summary(parts)["status"], "finished");
  EXPECT_EQ(summary(parts)["steps"], summary(straight)["steps"]);
  expect_same_results(straight, parts);
}

TEST(Application, SummaryIsOfAllStarts)
{
  const std::string folder = local("starts");
  remove(folder);
  run_scene(folder,
            {"--set",
             "Time/Steps in this run=17",
             "--set",
             "Mishap/Kind=warning",
             "--set",
             "Mishap/Step=9"});
  const Json first = summary(folder);
  EXPECT_TRUE(first["interruptions"].empty());
  run_scene(folder, {"--resume", "--set", "Time/Steps in this run=11"});
  const Json before =
    Json::parse(content(folder + "/checkpoint/0002/run.json"))["starts"];
  run_scene(folder, {"--resume"});
  const Json json = summary(folder);
  const Json &stops = json["interruptions"];
  ASSERT_EQ(stops.size(), 2U);
  EXPECT_EQ(stops[0], (Json{{"step", 17}, {"time", first["time"]}}));
  EXPECT_EQ(stops[1]["step"], 28);
  EXPECT_GT(stops[1]["time"], first["time"]);
  EXPECT_LT(stops[1]["time"], json["time"]);
  EXPECT_EQ(json["resumed_from_step"], 28);
  const Json &weight = json["assumptions"]["weight"];
  EXPECT_EQ(weight["estimate"], 1.);
  EXPECT_NE(weight["measured"], 1.);
  EXPECT_TRUE(!is_first_rank() || json["warnings"] == Json{"the spring creaks"})
    << json["warnings"];
  const Json &performance = json["performance"];
  const double loop = performance["wall_seconds"];
  EXPECT_GT(json["wall_seconds"], before["wall_seconds"]);
  EXPECT_GT(json["wall_seconds"], loop);
  EXPECT_GT(loop, before["loop_seconds"]);
  EXPECT_GT(before["loop_seconds"], 0.);
  EXPECT_GE(performance["core_seconds"], before["core_seconds"]);
  EXPECT_GE(performance["peak_memory_bytes"], before["peak_memory"]);
  EXPECT_GT(json["timers"]["advance"], before["timers"]["advance"]);
  // Cells times steps, of all starts.
  const double updates = performance["updates"];
  EXPECT_EQ(updates / json["steps"].get<double>(),
            first["performance"]["updates"].get<double>() / 17.);
  EXPECT_NEAR(
    performance["updates_per_second"], updates / loop, 1e-9 * updates);
  EXPECT_NEAR(performance["updates_per_second_per_core"].get<double>() *
                n_ranks(),
              updates / loop,
              1e-9 * updates / loop);
  // A later end is another run for the plan.
  remove(folder);
  const std::string keep = "Output/Checkpoint at the end=true";
  run_scene(folder, {"--set", "Time/End time=1.5", "--set", keep});
  run_scene(folder, {"--resume"});
  EXPECT_NE(summary(folder)["assumptions"]["weight"]["estimate"], 1.);
}

// A warning of the plan that the run refutes is none of the finished run.
TEST(Application, SummaryHasNoWarningThatDidNotComeTrue)
{
  const std::string folder = local("refuted");
  remove(folder);
  const std::string mishap = "Mishap/Kind=far away";
  run_scene(folder, {"--set", "Time/Steps in this run=17", "--set", mishap});
  EXPECT_TRUE(!is_first_rank() || summary(folder)["warnings"].size() == 1);
  run_scene(folder, {"--resume", "--set", mishap});
  const Json json = summary(folder);
  EXPECT_EQ(json["assumptions"]["weight"]["holds"], true);
  EXPECT_TRUE(json["warnings"].empty()) << json["warnings"];
  EXPECT_NE(content(folder + "/log.txt").find("did not come true"),
            std::string::npos);
}

TEST(Application, WallTimeStopsARun)
{
  const std::string folder = local("short_of_time");
  remove(folder);
  EXPECT_EQ(run_scene(folder, {"--set", "Time/Minutes in this run=1e-9"}).code,
            0);
  EXPECT_EQ(summary(folder)["status"], "stopped");
  EXPECT_EQ(summary(folder)["steps"], 1);
}

TEST(Application, CheckpointsDoNotChangeTheRun)
{
  const std::string straight = local("straight"), marked = local("marked");
  remove(straight);
  remove(marked);
  run_scene(straight);
  EXPECT_EQ(
    run_scene(marked, {"--set", "Output/Checkpoint every steps=4"}).code, 0);
  expect_same_results(straight, marked);
}

TEST(Application, AFinishedRunGoesOnToALaterEnd)
{
  const std::string folder = local("later");
  remove(folder);
  const std::string keep = "Output/Checkpoint at the end=true";
  EXPECT_EQ(
    run_scene(folder, {"--set", "Time/End time=1.5", "--set", keep}).code, 0);
  EXPECT_EQ(run_scene(folder, {"--resume", "--set", keep}).code, 0);
  EXPECT_EQ(summary(folder)["time"], 3.3);
  const std::string history = content(folder + "/history.csv");
  EXPECT_EQ(summary(folder)["steps"].get<int>() + 2, n_lines(history));
}

TEST(Application, SigtermWritesACheckpointAndLeavesWithItsCode)
{
  const std::string straight = local("straight"), folder = local("terminated");
  remove(straight);
  remove(folder);
  run_scene(straight);
  const Result result = run_scene(
    folder, {"--set", "Mishap/Kind=signal", "--set", "Mishap/Step=9"});
  EXPECT_EQ(result.code, 143);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(summary(folder)["status"], "stopped");
  EXPECT_EQ(summary(folder)["message"],
            "asked to stop by SIGTERM; --resume goes on from here");
  EXPECT_EQ(summary(folder)["steps"], 9);
  EXPECT_TRUE(summary(folder)["resumed_from_step"].is_null());
  EXPECT_EQ(run_scene(folder, {"--resume"}).code, 0);
  EXPECT_EQ(summary(folder)["resumed_from_step"], 9);
  expect_same_results(straight, folder);
}

TEST(Application, LargestNumberOfStepsFinishesTheRun)
{
  const std::string folder = local("few");
  remove(folder);
  run_scene(folder, {"--set", "Time/Largest number of steps=7"});
  EXPECT_EQ(summary(folder)["status"], "finished");
  EXPECT_EQ(summary(folder)["steps"], 7);
}

TEST(Application, CheckSaysTheCostAndWritesNothing)
{
  const std::string folder = local("checked");
  remove(folder);
  const Result result = run_scene(folder, {"--check"});
  EXPECT_EQ(result.code, 0);
  EXPECT_FALSE(exists(folder));
  const std::string ranks =
    n_ranks() == 1 ? " on 1 rank to " : " on 2 ranks to ";
  for (const char *word :
       {ranks.c_str(), "cells", "unknowns", "steps", "memory", "time"})
    EXPECT_EQ(result.out.find(word) != std::string::npos, is_first_rank())
      << word;
}

TEST(Application, PrintsParametersHelpAndVersion)
{
  const Result parameters =
    run_oscillator({"--print-parameters", "--set", "Oscillator/Mass=2.5"});
  const Result help = run_oscillator({"--help"});
  const Result version = run_oscillator({"--version"});
  for (const Result *result : {&parameters, &help, &version})
  {
    EXPECT_EQ(result->code, 0);
    EXPECT_EQ(result->err, "");
  }
  if (!is_first_rank())
    return;
  EXPECT_NE(parameters.out.find("  # [kg] The mass that swings."),
            std::string::npos);
  EXPECT_NE(parameters.out.find("  set Mass = 2.5\n"), std::string::npos);
  for (const char *option : {"--set", "--output", "--resume", "--check"})
    EXPECT_NE(help.out.find(option), std::string::npos) << option;
  EXPECT_EQ(version.out.find("oscillator 0."), 0u);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/study/column.h>
#include <contrecoup/study/run_record.h>
#include <contrecoup/study/variant_forecast.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

using namespace contrecoup;
using namespace contrecoup::study;

namespace
{
/// Message of the InputError that @p work throws; empty: none.
template <typename Work>
std::string refusal(const Work &work)
{
  try
  {
    work();
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}

/// The output folder of a scene with a blast and a body.
class SceneFolder : public testing::Test
{
protected:
  void SetUp() override
  {
    write("manifest.json", R"({"status": "finished"})");
    write("scene.json", R"({"distance": 2.5, "title": "x", "ranks": 2,
      "tables": {"answer": {"arrival": 2e-3, "lethality": 0.1, "angle": null}},
      "units": {"distance": "m", "arrival": "s", "angle": "degrees"},
      "stages": [
      {"name": "blast", "folder": "blast", "wall_seconds": 3,
       "core_seconds": 5, "peak_memory": 100},
      {"name": "biomechanics", "folder": "biomechanics", "wall_seconds": 4,
       "core_seconds": 7, "peak_memory": 80}]})");
    write("blast/summary.json", R"({"status": "finished", "steps": 10,
      "retries": 0, "results": {"peak": {"value": 3.5, "unit": "Pa"}},
      "assumptions": {"air": {"unit": "-", "measured": null, "at_most": 1}}})");
    write("biomechanics/summary.json",
          R"({"status": "finished", "steps": 20, "retries": 2})");
    write("blast/gauges.csv",
          "measure,place,value,unit,definition\n"
          "exposure,trunk,0.5,-,\"one, two\"\n"
          "velocity,left ear,nan,m/s,\"three\"\n");
    write("blast/history.csv", "step,time [s],mass [kg]\n0,0,2\n5,1,4\n");
    write("blast/loads.csv",
          "time [s],chest [Pa],back [Pa]\n"
          "0,0,0\n1,2,nan\n2,-1,1\n3,-1,1\n");
  }

  void write(const std::string &name, const std::string &text) const
  {
    const std::filesystem::path file = folder_.path() + "/" + name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }

  contrecoup::io::TemporaryFolder folder_;
};
} // namespace

// The run cuts a positive phase off, in a summary and in a table.
TEST_F(SceneFolder, MarksLowerLimits)
{
  write("blast/summary.json", R"({"results": {
    "probe_1_impulse": {"value": 3, "unit": "Pa s"},
    "probe_1_peak": {"value": 4, "unit": "Pa"},
    "probe_1_cut_off": {"value": 1, "unit": "-"},
    "probe_2_impulse": {"value": 3, "unit": "Pa s"}}})");
  write("blast/gauge_measures.csv",
        "place,impulse [Pa s],positive phase [s],cut off [-]\n"
        "chest,1,2,1\nback,1,2,0\n");
  write("blast/gauge_injury.csv",
        "measure,place,value,unit,definition,cut off [-]\n"
        "velocity,chest,1,m/s,\"a, b\",1\nvelocity,back,1,m/s,\"a, b\",0\n");
  write("biomechanics/summary.json", R"({"results": {
    "injury_chest_wall_velocity": {"value": 3, "unit": "m/s"},
    "injury_chest_wall_velocity_cut_off": {"value": 1, "unit": "-"},
    "injury_chest_wall_velocity_mesh": {"value": 2, "unit": "m/s"}}})");
  const RunOutputs outputs(folder_.path());
  for (const char *limit : {"blast/results.probe_1_impulse",
                            "biomechanics/results.injury_chest_wall_velocity",
                            "blast/gauge_measures.csv:chest:impulse",
                            "blast/gauge_measures.csv:chest:positive phase",
                            "blast/gauge_injury.csv:velocity chest:value"})
    EXPECT_TRUE(outputs.at(limit).is_lower_limit) << limit;
  for (const char *other :
       {"blast/results.probe_1_peak",
        "biomechanics/results.injury_chest_wall_velocity_mesh",
        "blast/results.probe_2_impulse",
        "blast/gauge_measures.csv:back:impulse",
        "blast/gauge_injury.csv:velocity back:value"})
    EXPECT_FALSE(outputs.at(other).is_lower_limit) << other;
}

TEST_F(SceneFolder, HasOutputsOfAllStagesAndFiles)
{
  const RunOutputs outputs(folder_.path());
  const std::vector<std::tuple<std::string, double, std::string>> expected = {
    {"scene.json:distance", 2.5, "m"},
    {"scene.json:ranks", 2., ""},
    {"scene.json:tables.answer.arrival", 2e-3, "s"},
    {"scene.json:tables.answer.lethality", 0.1, ""},
    {"blast/results.peak", 3.5, "Pa"},
    {"blast/assumptions.air.at_most", 1., ""},
    {"blast/gauges.csv:exposure trunk:value", 0.5, ""},
    {"blast/history.csv:last:mass", 4., "kg"},
    {"blast/history.csv:impulse:mass", 1., "kg s"},
    {"blast/loads.csv:largest:chest", 2., "Pa"},
    {"blast/loads.csv:smallest:chest", -1., "Pa"},
    {"blast/loads.csv:last:back", 1., "Pa"},
    {"blast/loads.csv:arrival:chest", 0.5, "s"},
    {"blast/loads.csv:impulse:chest", 1.5, "Pa s"}};
  for (const auto &[address, value, unit] : expected)
  {
    EXPECT_DOUBLE_EQ(outputs.at(address).value, value) << address;
    EXPECT_EQ(outputs.at(address).unit, unit) << address;
  }
}

TEST_F(SceneFolder, KnowsWhatWasNotComputed)
{
  const RunOutputs outputs(folder_.path());
  for (const char *address : {"blast/assumptions.air.measured",
                              "blast/gauges.csv:velocity left ear:value",
                              "blast/loads.csv:peak:back",
                              "blast/loads.csv:impulse:back"})
    EXPECT_TRUE(std::isnan(outputs.at(address).value)) << address;
}

TEST_F(SceneFolder, SaysTheNearestOutput)
{
  const RunOutputs outputs(folder_.path());
  const std::string text = refusal([&]() { outputs.at("blast/resluts.peak"); });
  EXPECT_NE(text.find("did you mean \"blast/results.peak\"?"),
            std::string::npos)
    << text;
}

TEST_F(SceneFolder, LeavesDamagedFilesOut)
{
  write("blast/ragged.csv", "a,b\n1\n");
  write("blast/empty.csv", "");
  write("blast/broken.json", "{");
  const RunOutputs outputs(folder_.path());
  for (const std::string &address : outputs.names())
    for (const char *file : {"ragged", "empty", "broken"})
      EXPECT_EQ(address.find(file), std::string::npos) << address;
}

TEST_F(SceneFolder, RecordsOfNewerFormatsAreRefused)
{
  for (const char *name :
       {"blast/summary.json", "scene.json", "manifest.json", "summary.json"})
  {
    write(name, R"({"format": 2})");
    EXPECT_THROW(read_record(folder_.path()), contrecoup::InputError) << name;
    write(name, name == std::string("summary.json") ? "" : R"({"format": 1})");
  }
}

TEST_F(SceneFolder, HasTheSumsOfItsStages)
{
  const RunRecord record = read_record(folder_.path());
  EXPECT_EQ(record.status, "finished");
  EXPECT_EQ(record.steps, 30.);
  EXPECT_EQ(record.retries, 2.);
  EXPECT_EQ(record.wall_seconds, 7.);
  EXPECT_EQ(record.core_seconds, 12.);
  EXPECT_EQ(record.memory, 100.);
  EXPECT_TRUE(std::isnan(record.cells));
  EXPECT_TRUE(read_record(folder_.path() + "/none").status.empty());
}

TEST_F(SceneFolder, HasTheWarningsOfItsStages)
{
  write("scene.json", R"({"warnings": ["a", "of the scene"], "stages": [
    {"name": "blast", "folder": "blast"},
    {"name": "coarser_blast", "folder": "coarser_blast"},
    {"name": "biomechanics", "folder": "biomechanics"}]})");
  write("blast/summary.json", R"({"warnings": ["a", "b"]})");
  write("coarser_blast/summary.json", R"({"warnings": ["coarse"]})");
  write("biomechanics/summary.json", R"({"warnings": ["b", "c", 3]})");
  const std::vector<std::string> expected{"a", "b", "c", "of the scene"};
  EXPECT_EQ(read_record(folder_.path()).warnings, expected);
  EXPECT_EQ(read_record(folder_.path() + "/blast").warnings.size(), 2u);
}

TEST_F(SceneFolder, FillsColumns)
{
  const RunOutputs outputs(folder_.path());
  const auto columns = find_columns(
    parse_columns("blast/results.peak as peak; blast/loads.csv:arrival:*; "
                  "blast/results.none if any"),
    {&outputs});
  std::vector<std::string> titles;
  for (const Column &column : columns)
    titles.push_back(title_with_unit(column));
  EXPECT_EQ(titles,
            (std::vector<std::string>{
              "peak [Pa]", "arrival chest [s]", "arrival back [s]", "none"}));
}

TEST_F(SceneFolder, NamesNoColumnAsAFactor)
{
  const RunOutputs outputs(folder_.path());
  const auto columns = find_columns(
    parse_columns("blast/results.peak; blast/loads.csv:arrival:chest"),
    {&outputs},
    {"Peak", "arrival chest"});
  ASSERT_EQ(columns.size(), 2u);
  EXPECT_EQ(columns[0].title, "blast peak");
  EXPECT_EQ(columns[1].title, "blast arrival chest");
}

TEST_F(SceneFolder, RefusesColumnsThatNoRunHas)
{
  const RunOutputs outputs(folder_.path());
  const auto find = [&](const std::string &text) {
    return refusal([&]() { find_columns(parse_columns(text), {&outputs}); });
  };
  EXPECT_NE(
    find("blast/results.peek").find("did you mean \"blast/results.peak"),
    std::string::npos);
  EXPECT_NE(find("blast/resluts.*"), "");
  EXPECT_EQ(find("blast/results.peek if any"), "");
}

TEST(Columns, RefusesWhatIsNoAddress)
{
  for (const char *text : {"blast/",
                           "gauges.csv:peak",
                           "gauges.txt:a:b",
                           "results.*  as several",
                           "results.a; results.a"})
    EXPECT_NE(refusal([&]() { parse_columns(text); }), "") << text;
}

// Results of probes are those of the probes that the history has.
TEST(VariantForecast, KnowsTheProbesOfARun)
{
  const std::vector<std::string> two = {"results.*",
                                        "probes.csv:peak:probe_1_pressure",
                                        "probes.csv:peak:probe_2_pressure",
                                        "blast/results.*"};
  EXPECT_TRUE(can_have(two, "results.probe_2_impulse"));
  EXPECT_FALSE(can_have(two, "results.probe_3_impulse"));
  EXPECT_FALSE(can_have(two, "results.probe_22_impulse"));
  EXPECT_TRUE(can_have(two, "blast/results.probe_3_impulse"));
  EXPECT_EQ(suggest_output(two, "results.probe_3_impulse").find("did you mean"),
            std::string::npos);
}

TEST(VariantForecast, KnowsWhichOutputsArePossible)
{
  const std::vector<std::string> outputs = {"steps",
                                            "results.*",
                                            "gauges.csv:*",
                                            "blast/results.*",
                                            "history.csv:peak:*",
                                            "measures.csv:left ear:peak"};
  for (const char *address : {"steps",
                              "results.a",
                              "gauges.csv:a:b",
                              "blast/*",
                              "*.a",
                              "history.csv:peak:energy",
                              "measures.csv:*:peak"})
    EXPECT_TRUE(can_have(outputs, address)) << address;
  for (const char *address : {"stepps",
                              "resluts.a",
                              "gauge.csv:a:b",
                              "body/results.a",
                              "check*",
                              "history.csv:peek:energy",
                              "measures.csv:chest:peak",
                              "results.a:b"})
    EXPECT_FALSE(can_have(outputs, address)) << address;
  EXPECT_EQ(suggest_output(outputs, "resluts.hic"),
            "; did you mean \"results.hic\"?");
  EXPECT_EQ(suggest_output(outputs, "gauge.csv:ear:peak"),
            "; did you mean \"gauges.csv:ear:peak\"?");
  EXPECT_EQ(suggest_output(outputs, "history.csv:peek:energy"),
            "; did you mean \"history.csv:peak:energy\"?");
  EXPECT_EQ(suggest_output(outputs, "measures.csv:left eye:peak"),
            "; did you mean \"measures.csv:left ear:peak\"?");
  // Any column of history.csv may be there, and its pattern takes all words.
  EXPECT_EQ(suggest_output(
              {"history.csv:arrival:*", "probes.csv:arrival:probe_1_pressure"},
              "probes.csv:arrival:pressure_1"),
            "; did you mean \"probes.csv:arrival:probe_1_pressure\"?");
  // Any address below a stage that says nothing of its results is possible,
  // and would be a poor advice.
  const std::vector<std::string> stages = {
    "anatomy/*", "anatomy/parts.csv:*", "blast/results.*"};
  EXPECT_FALSE(can_have(stages, "anatomy/biomechanics/results.peak"));
  for (const char *address :
       {"biomechanics/results.injury_intracranial_pressure_peak",
        "blast/gauge_measures.csv:chest:peak"})
    EXPECT_EQ(suggest_output(stages, address),
              "; it has anatomy/*, anatomy/parts.csv:*, blast/results.*")
      << address;
  EXPECT_EQ(suggest_output(outputs, "something quite different"),
            "; it has results.*, gauges.csv:*, blast/results.*, history.csv:*, "
            "measures.csv:*");
}

TEST(VariantForecast, AddsTheCostsOfRunsAtOnce)
{
  std::vector<VariantForecast> forecasts(3);
  for (std::size_t i = 0; i < 3; ++i)
  {
    CostEstimate &cost = forecasts[i].report.cost;
    cost.steps = 10.;
    cost.memory = 100. * static_cast<double>(i + 1);
    cost.seconds = 2.;
    cost.output = 5.;
  }
  const CostEstimate sum = sum_of(forecasts, 2);
  EXPECT_EQ(sum.steps, 30.);
  EXPECT_EQ(sum.memory, 300.);
  EXPECT_EQ(sum.seconds, 4.);
  EXPECT_EQ(sum.output, 15.);
  // Trial runs alone know some figures; those of a refused run do not matter.
  forecasts[1].report.cost.memory = forecasts[1].report.cost.seconds = 0.;
  forecasts[2].report.cost = CostEstimate();
  forecasts[2].refusal = "too coarse";
  const CostEstimate partial = sum_of(forecasts, 2);
  EXPECT_EQ(partial.memory, 0.);
  EXPECT_EQ(partial.seconds, 0.);
  EXPECT_EQ(partial.steps, 20.);
  EXPECT_EQ(partial.output, 10.);
}

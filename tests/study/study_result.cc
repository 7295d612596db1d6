// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/study/report.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

using namespace contrecoup;
using namespace contrecoup::study;

namespace
{
/// Runs of two schemes on three levels that left their summaries.
class FinishedStudy : public testing::Test
{
protected:
  void SetUp() override
  {
    std::ofstream(folder_.path() + "/base.prm") << "";
  }

  void read(const std::vector<std::string> &overrides)
  {
    dealii::ParameterHandler prm;
    StudyParameters::declare_parameters(prm);
    std::vector<Assignment> assignments;
    for (const std::string text : {"Vary scheme/Entry=Method/Scheme",
                                   "Vary scheme/Values=first; second",
                                   "Vary level/Entry=Domain/Level",
                                   "Vary level/Values=1; 2; 3",
                                   "Vary level/Refinement=by level"})
      assignments.push_back(parse_override(text));
    assignments.push_back(
      parse_override("Study/Parameter file=" + folder_.path() + "/base.prm"));
    for (const std::string &text : overrides)
      assignments.push_back(parse_override(text));
    apply_assignments(assignments, prm);
    parameters_.parse_parameters(prm);
    for (const Variant &variant :
         make_design(parameters_.factors, parameters_.design))
      tasks_.push_back(make_task(variant));
  }

  /// The error of scheme number n is 2^-(n level), its cost 10 n 4^level.
  Task make_task(const Variant &variant)
  {
    Task task;
    task.variant = variant;
    const double order = variant.labels[0] == "first" ? 1. : 2.;
    const double level = variant.numbers[1];
    task.folder = folder_.path() + "/" + variant.labels[0] + variant.labels[1];
    std::filesystem::create_directories(task.run_folder());
    std::ofstream(task.run_folder() + "/summary.json") << nlohmann::json{
      {"unknowns", 10},
      {"errors", {{"density_L1", std::exp2(-order * level)}}},
      {"value", 7. + std::exp2(-order * level)},
      {"performance", {{"core_seconds", 10. * order * std::exp2(2. * level)}}}};
    task.outcome = Outcome();
    task.outcome->kind = "stable";
    return task;
  }

  contrecoup::io::TemporaryFolder folder_;
  StudyParameters parameters_;
  std::vector<Task> tasks_;
};
} // namespace

TEST_F(FinishedStudy, HasOrdersFrontAndRecommendation)
{
  read({"Error/Wanted error=0.1"});
  const StudyResult result = evaluate(parameters_, tasks_);
  ASSERT_EQ(result.rows.size(), 6u);
  EXPECT_EQ(result.series, (std::vector<std::string>{"first", "second"}));
  EXPECT_TRUE(std::isnan(result.rows[0].order));
  EXPECT_NEAR(result.rows[2].order, 1., 1e-12);
  EXPECT_NEAR(result.rows[4].order, 2., 1e-12);
  EXPECT_EQ(result.rows[5].cost, 1280.);
  EXPECT_TRUE(result.rows[4].on_front);
  EXPECT_FALSE(result.rows[2].on_front);
  ASSERT_TRUE(result.recommended);
  EXPECT_EQ(*result.recommended, 4u);
  const std::string text = to_markdown(parameters_, result);
  EXPECT_NE(text.find("| second | 2 | stable | 10 |"), std::string::npos)
    << text;
  EXPECT_NE(text.find("scheme = second, level = 2"), std::string::npos) << text;
}

TEST_F(FinishedStudy, LeavesOutWhatFailed)
{
  read({"Error/Wanted error=0.1"});
  tasks_[4].outcome->kind = "unstable";
  tasks_[4].outcome->reason = "negative density";
  tasks_[0].outcome.reset();
  const StudyResult result = evaluate(parameters_, tasks_);
  EXPECT_EQ(result.rows.size(), 5u);
  EXPECT_EQ(result.rows[*result.recommended].variant.labels[1], "3");
  // The order now spans two levels.
  EXPECT_NEAR(result.rows[4].order, 2., 1e-12);
  EXPECT_NE(to_csv(parameters_, result).find("unstable,\"negative density\""),
            std::string::npos);
  EXPECT_NE(to_markdown(parameters_, result).find("- second, 2: unstable"),
            std::string::npos);
}

TEST_F(FinishedStudy, ExplainsRetries)
{
  read({"Error/Kind=none"});
  const auto text = [&] {
    return to_markdown(parameters_, evaluate(parameters_, tasks_));
  };
  EXPECT_EQ(text().find("retried"), std::string::npos);
  tasks_[1].outcome->kind = "retried";
  EXPECT_NE(text().find("\nretried: complete; steps that failed were repeated"),
            std::string::npos)
    << text();
}

TEST_F(FinishedStudy, ListsWarningsOfRuns)
{
  read({"Error/Wanted error=0.1"});
  StudyResult result = evaluate(parameters_, tasks_);
  EXPECT_EQ(result.n_warned(), 0u);
  EXPECT_EQ(to_markdown(parameters_, result).find("Warnings"),
            std::string::npos);
  result.rows[0].record.warnings = {"coarse", "long"};
  result.rows[2].record.warnings = {"long"};
  EXPECT_EQ(result.n_warned(), 2u);
  const std::string text = to_markdown(parameters_, result);
  const auto labels = [&](const std::size_t row) {
    return result.rows[row].variant.labels[0] + ", " +
           result.rows[row].variant.labels[1];
  };
  EXPECT_NE(text.find("Warnings of the runs:\n\n- " + labels(0) +
                      ": coarse\n- " + labels(0) + "; " + labels(2) +
                      ": long\n"),
            std::string::npos)
    << text;
  EXPECT_EQ(
    told_warnings({{"a", {"x", "y"}}, {"b", {"y", "z"}}}, 2),
    (std::vector<std::string>{"a: x", "a; b: y", "further warnings: 1"}));
}

// All errors are taken from the reference run.
TEST_F(FinishedStudy, ListsWarningsOfTheReference)
{
  const std::string folder = folder_.path() + "/reference";
  read({"Error/Kind=reference run",
        "Error/Reference folder=" + folder,
        "Error/Name=value"});
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/summary.json")
    << R"({"value": 7.0, "warnings": ["long"]})";
  StudyResult result = evaluate(parameters_, tasks_);
  EXPECT_EQ(result.n_warned(), 0u);
  result.rows[0].record.warnings = {"long"};
  EXPECT_NE(to_markdown(parameters_, result)
              .find("\nWarnings of the runs:\n\n- the reference run; first, 1: "
                    "long\n"),
            std::string::npos);
}

TEST_F(FinishedStudy, ExtrapolatesWithinEachSeries)
{
  read({"Error/Kind=self convergence", "Error/Name=value"});
  const StudyResult result = evaluate(parameters_, tasks_);
  for (const ResultRow &row : result.rows)
  {
    const double order = row.series == 0 ? 1. : 2.;
    EXPECT_NEAR(
      row.error, std::exp2(-order * row.variant.numbers[1]) / 7., 1e-9);
  }
  EXPECT_NEAR(result.rows[5].order, 2., 1e-6);
  EXPECT_EQ(result.remarks.size(), 2u);
}

TEST_F(FinishedStudy, TakesSizesOfCellsForMeshWidths)
{
  // Errors of levels 1, 2, 3, on sizes that halve twice from one to the next.
  read({"Vary level/Values=16; 4; 1", "Vary level/Refinement=by size"});
  for (const std::string scheme : {"first", "second"})
    for (unsigned int level = 1; level <= 3; ++level)
    {
      Task &task = tasks_[(scheme == "first" ? 0 : 3) + level - 1];
      const double order = scheme == "first" ? 1. : 2.;
      std::ofstream(task.run_folder() + "/summary.json") << nlohmann::json{
        {"errors", {{"density_L1", std::exp2(-order * level)}}}};
    }
  const StudyResult result = evaluate(parameters_, tasks_);
  EXPECT_EQ(result.rows[2].width, 1.);
  EXPECT_NEAR(result.rows[2].order, 0.5, 1e-12);
  EXPECT_NEAR(result.rows[5].order, 1., 1e-12);
}

// Numbers of cells are no sizes: nothing can be said of errors then.
TEST_F(FinishedStudy, LeavesOutWhatUnknownsContradict)
{
  read({"Vary level/Values=100; 200; 400",
        "Vary level/Refinement=by size",
        "Error/Kind=self convergence",
        "Error/Name=value"});
  for (const Task &task : tasks_)
    std::ofstream(task.run_folder() + "/summary.json")
      << nlohmann::json{{"unknowns", 32. * task.variant.numbers[1]},
                        {"value", 7. + 1. / task.variant.numbers[1]}};
  const StudyResult result = evaluate(parameters_, tasks_);
  for (const ResultRow &row : result.rows)
    EXPECT_TRUE(std::isnan(row.error) && std::isnan(row.order));
  EXPECT_FALSE(result.recommended);
  ASSERT_EQ(result.remarks.size(), 2U); // one for each scheme
  EXPECT_NE(result.remarks[0].find("Vary level/Refinement: what it calls the "
                                   "finest mesh has 3200 unknowns"),
            std::string::npos)
    << result.remarks[0];
}

TEST_F(FinishedStudy, MarksWhatTheEndOfARunCutsOff)
{
  read({"Study/Columns=results.probe_1_impulse"});
  for (Task &task : tasks_)
    std::ofstream(task.run_folder() + "/summary.json") << nlohmann::json{
      {"errors", {{"density_L1", 1.}}},
      {"results",
       {{"probe_1_impulse", {{"value", 64.5}, {"unit", "Pa s"}}},
        {"probe_1_cut_off",
         {{"value", &task == &tasks_[1] ? 1 : 0}, {"unit", "-"}}}}}};
  const StudyResult result = evaluate(parameters_, tasks_);
  EXPECT_EQ(result.n_cut_off(), 1u);
  const std::string text = to_markdown(parameters_, result);
  EXPECT_NE(text.find("| ≥ 64.5 |"), std::string::npos) << text;
  EXPECT_NE(text.find("| 64.5 |"), std::string::npos) << text;
  EXPECT_NE(text.find("≥: a lower limit"), std::string::npos) << text;
  EXPECT_NE(
    to_csv(parameters_, result).find(",\"results.probe_1_impulse\",64.5,"),
    std::string::npos);
  const auto json = nlohmann::json::parse(to_json(parameters_, result));
  EXPECT_TRUE(json["rows"][1]["lower_limits"][0].get<bool>());
  EXPECT_FALSE(json["rows"][0]["lower_limits"][0].get<bool>());
}

TEST_F(FinishedStudy, MarksAContactThatLasts)
{
  read({"Study/Columns=results.contact_end; results.contact_impulse; "
        "results.peak_contact_force; results.peak_contact_force_of_step; "
        "results.contrecoup_pressure"});
  for (Task &task : tasks_)
    std::ofstream(task.run_folder() + "/summary.json") << nlohmann::json{
      {"errors", {{"density_L1", 1.}}},
      {"results",
       {{"contact_end", {{"value", nullptr}, {"unit", "s"}}},
        {"contact_impulse", {{"value", 9.18}, {"unit", "N s"}}},
        {"peak_contact_force", {{"value", 9510.}, {"unit", "N"}}},
        {"peak_contact_force_of_step", {{"value", 9990.}, {"unit", "N"}}},
        {"contact_cut_off", {{"value", 1.}, {"unit", "-"}}},
        {"contrecoup_pressure", {{"value", -41700.}, {"unit", "Pa"}}},
        {"contrecoup_pressure_cut_off", {{"value", 1.}, {"unit", "-"}}}}}};
  const std::string text =
    to_markdown(parameters_, evaluate(parameters_, tasks_));
  EXPECT_NE(text.find("| unknown | ≥ 9.18 | ≥ 9510 | ≥ 9990 | ≤ -4.17e+04 |"),
            std::string::npos)
    << text;
}

TEST_F(FinishedStudy, ShowsFurtherNumbersOfRunsAndReference)
{
  read({"Study/Columns=value; errors.none if any",
        "Error/Kind=reference run",
        "Error/Name=value",
        "Error/Reference folder=" + folder_.path() + "/second3/run"});
  tasks_[3].outcome->kind = "unstable";
  const StudyResult result = evaluate(parameters_, tasks_);
  EXPECT_EQ(result.empty_columns(), std::vector<std::string>{"none"});
  ASSERT_EQ(result.rows[4].columns.size(), 2u);
  EXPECT_EQ(result.n_unfinished(), 1u);
  EXPECT_EQ(result.rows[4].columns[0], 7.0625);
  EXPECT_TRUE(std::isnan(result.rows[4].columns[1]));
  const std::string text = to_markdown(parameters_, result);
  for (const std::string line : {"| scheme | level | value | none |",
                                 "| second | 2 | 7.062 | unknown |",
                                 "| second | 1 | unstable | unstable |",
                                 "| reference run |  | 7.016 | unknown |",
                                 "Not finished, 1 of 6:"})
    EXPECT_NE(text.find("\n" + line + "\n"), std::string::npos) << text;
  const std::string table = to_csv(parameters_, result);
  EXPECT_NE(table.find(",\"value\",\"errors.none\",folder\n"),
            std::string::npos)
    << table;
  EXPECT_NE(table.find(",7.0625,,\""), std::string::npos) << table;
}

TEST_F(FinishedStudy, TablesNoErrorsWhereNoneIsMeasured)
{
  read({"Error/Kind=none"});
  const StudyResult result = evaluate(parameters_, tasks_);
  const std::string text = to_markdown(parameters_, result);
  EXPECT_NE(
    text.find(" steps | core seconds |\n|---|---|---|---:|---:|---:|\n"),
    std::string::npos)
    << text;
  for (const std::string word : {"error", "order", "best", "Best"})
    EXPECT_EQ(text.find(word), std::string::npos) << text;
  EXPECT_EQ(to_csv(parameters_, result).find(",no,"), std::string::npos);
}

TEST_F(FinishedStudy, CountsAnErrorThatIsNoNumberAsUnstable)
{
  read({});
  std::ofstream(tasks_[1].run_folder() + "/summary.json")
    << R"({"errors": {"density_L1": null}})";
  const StudyResult result = evaluate(parameters_, tasks_);
  EXPECT_EQ(result.rows[1].outcome.kind, "unstable");
  EXPECT_FALSE(result.rows[1].on_front);
}

TEST_F(FinishedStudy, RecommendedFileIsCompleteAndHasTheUsersOutput)
{
  read({"Error/Wanted error=0.1"});
  const StudyResult result = evaluate(parameters_, tasks_);
  const std::string used = folder_.path() + "/used.prm";
  std::ofstream(used) << "# old comment\n\nsubsection Method\n"
                         "  set Scheme = second\n  subsection Deep\n"
                         "    set Entry = a = b\n  end\nend\n"
                         "subsection Output\n  set Fields = false\nend\n";
  const std::string file = folder_.path() + "/recommended.prm";
  std::ofstream(file) << recommended_file(
    parameters_, result, used, {{"Output/Fields", "true"}});
  std::map<std::string, std::string> values;
  for (const Assignment &assignment : read_assignments(file))
    values[assignment.entry] = assignment.value;
  EXPECT_EQ(values,
            (std::map<std::string, std::string>{
              {"Scheme", "second"}, {"Entry", "a = b"}, {"Fields", "true"}}));
}

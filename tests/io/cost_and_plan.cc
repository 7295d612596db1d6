// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/run/time_parameters.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/processor_time.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/application/cost_forecast.h>
#include <contrecoup/io/application/cost_laws.h>
#include <contrecoup/io/application/trial_run.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/io/run/cost_cache.h>
#include <contrecoup/io/run/plan_table.h>

#include "oscillator.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>

using namespace contrecoup;
using namespace contrecoup::io;

namespace
{
/// A stage in 2-D that is followed by one in 3-D, in 200 steps of 1 ms of
/// processor time each.
class SlowStages : public Oscillator
{
public:
  explicit SlowStages(const double hand_over)
    : Oscillator(MPI_COMM_WORLD)
    , hand_over_(hand_over)
  {}
  StepReport advance(const double largest_step) override
  {
    const double begin = processor_seconds();
    while (processor_seconds() < begin + 1e-3)
    {}
    return Oscillator::advance(std::min(largest_step, 0.005));
  }
  unsigned int dimension() const override
  {
    return time() < hand_over_ ? 2 : 3;
  }
  std::optional<double> expected_hand_over() override
  {
    return time() < hand_over_ ? std::optional(hand_over_) : std::nullopt;
  }

private:
  const double hand_over_; ///< [s]
};
} // namespace

namespace
{
/// Cost of SlowStages by trials of twice @p budget [s].
CostEstimate cost_of_stages(const double hand_over, const double budget)
{
  ApplicationDescription description = oscillator_application();
  description.create = [&](dealii::ParameterHandler &, MPI_Comm) {
    return std::make_unique<SlowStages>(hand_over);
  };
  description.adapts = [](const dealii::ParameterHandler &) { return true; };
  description.coarsen = [](dealii::ParameterHandler &, unsigned int) {
    return true;
  };
  dealii::ParameterHandler prm;
  TimeParameters::declare_parameters(prm);
  description.declare_parameters(prm);
  prm.enter_subsection("Time");
  prm.set("End time", "1");
  prm.leave_subsection();
  CostEstimate rough;
  rough.cells = rough.unknowns = 7.;
  Collective collective(MPI_COMM_WORLD);
  return forecast_cost(description, prm, rough, budget, collective);
}

void expect_known(const CostEstimate &cost, const bool is_known)
{
  for (const double number :
       {cost.cells, cost.unknowns, cost.memory, cost.output, cost.steps})
    EXPECT_EQ(number > 0., is_known);
}
} // namespace

// A trial that is stopped in a stage does not tell how its mesh continues.
TEST(CostForecast, IsUnknownWhereNoTrialComesToTheEndOfTheLastStage)
{
  for (const double hand_over : {0.01, 0.9})
    expect_known(cost_of_stages(hand_over, 0.02), false);
  expect_known(cost_of_stages(0.01, 0.2), true);
}

TEST(CostForecast, IsUnknownWhereTrialsEndInAFirstStage)
{
  setenv("CONTRECOUP_CHECK_LEVELS", "2 1", 1);
  for (const double hand_over : {0.9, 2.})
    expect_known(cost_of_stages(hand_over, 0.02), hand_over < 1.);
  unsetenv("CONTRECOUP_CHECK_LEVELS");
}

// A stage in 2-D of one step on cells that are too large to refine.
TEST(CostForecast, BelievesNoTrialOfAFewStepsInAStage)
{
  const auto trial_of = [](const unsigned int dimension, const double steps) {
    TrialStage first, last;
    first.dimension = dimension;
    first.steps = steps;
    last.dimension = 3;
    last.steps = last.largest_cells = 100.;
    last.cell_steps = 9e3;
    Trial trial;
    trial.stages = {first, last};
    return trial;
  };
  EXPECT_TRUE(trial_of(1, 3.).tells_of_finer());
  EXPECT_FALSE(trial_of(2, 3.).tells_of_finer());
  EXPECT_TRUE(trial_of(2, 30.).tells_of_finer());
  Trial still = trial_of(2, 30.);
  still.stages.back().cell_steps = 1e4;
  EXPECT_FALSE(still.tells_of_finer());
  EXPECT_FALSE(still.has_few_steps());
  EXPECT_FALSE(Trial().tells_of_finer());
}


// Both terms are found again from two values.
TEST(CostForecast, ExtrapolatesSurfacesAndVolumes)
{
  const auto cells = [](const double level) {
    return 5. * std::pow(4., level) + 0.3 * std::pow(8., level);
  };
  EXPECT_NEAR(extrapolate(cells(2), cells(3), 2, 2., 3.) / cells(5), 1., 1e-12);
  EXPECT_NEAR(extrapolate(cells(2), cells(3), 0, 2., 3.) / cells(3), 1., 1e-12);
  // From trials that are not neighbours, as some scenes cannot be so coarse.
  EXPECT_NEAR(
    extrapolate(cells(1), cells(4), 2, 2., 3., 3) / cells(6), 1., 1e-12);
}

TEST(CostForecast, ExtrapolatesBeyondBothLaws)
{
  EXPECT_DOUBLE_EQ(extrapolate(1., 16., 1, 2., 3.), 128.); // not faster
  EXPECT_DOUBLE_EQ(extrapolate(1., 2., 2, 2., 3.), 8.);    // at its own rate
  EXPECT_DOUBLE_EQ(extrapolate(2., 1., 3, 0., 1.), 1.);    // never falls
  EXPECT_DOUBLE_EQ(extrapolate(0., 1., 2, 0., 1.), 2.);    // no trial before
  EXPECT_DOUBLE_EQ(extrapolate(1., 64., 1, 2., 3., 3), 256.);
}

TEST(CostForecast, RefinesLayersOfAnAdaptiveMesh)
{
  // Growth between that of surfaces and volumes, besides cells that stay.
  const auto cells = [](const double level) {
    return 100. + 20. * std::pow(2., 2.25 * level);
  };
  EXPECT_DOUBLE_EQ(extrapolate_cells(0., 3., 2, 2, 1), 24.);
  EXPECT_NEAR(extrapolate_cells(100., 500., 1, 3, 1), 2378., 1.);
  EXPECT_NEAR(
    extrapolate_cells(cells(0), cells(1), 2, 3, 1) / cells(3), 1., 1e-12);
  EXPECT_NEAR(
    extrapolate_cells(cells(0), cells(2), 1, 3, 2) / cells(3), 1., 1e-12);
  EXPECT_DOUBLE_EQ(extrapolate_cells(100., 90., 3, 3, 1), 90.);
}

// Steps of 0.3 kg of PETN, whose centre is the hotter, the finer its cells.
TEST(CostForecast, FollowsAConvergingShock)
{
  const std::vector<double> found{
    1879., 4440., 10864., 28347., 71053., 182752.};
  for (const unsigned int last : {2, 3, 4})
  {
    const Powers powers =
      powers_of_steps(found[last - 2], found[last - 1], found[last], 1, 1);
    const unsigned int levels = found.size() - 1 - last;
    const double steps = extrapolate(
      found[last - 1], found[last], levels, powers.low, powers.high);
    EXPECT_NEAR(steps / found.back(), 1., 0.1) << levels;
  }
  const auto largest = [](const double first, const double middle) {
    return powers_of_steps(first, middle, 128., 2, 4).high;
  };
  EXPECT_DOUBLE_EQ(largest(1., 8.), 1.);
  EXPECT_DOUBLE_EQ(largest(1., 4.), 1.);
  EXPECT_DOUBLE_EQ(largest(1., 2.5), 1.);
  EXPECT_DOUBLE_EQ(largest(0.25, 2.), 1.5);
  EXPECT_DOUBLE_EQ(largest(0., 3.), 1.);
}

TEST(CostForecast, ApproachesALimit)
{
  const auto steps = [](const double level) {
    return 300. - 200. * std::pow(2., -level);
  };
  EXPECT_NEAR(extrapolate_to_limit(steps(1), steps(2), 3), steps(5), 1e-10);
  EXPECT_NEAR(extrapolate_to_limit(steps(1), steps(4), 2, 3), steps(6), 1e-10);
  EXPECT_DOUBLE_EQ(extrapolate_to_limit(100., 200., 0), 200.);
}

TEST(CostCache, GivesBackWhatItKeptForTheSameScene)
{
  const TemporaryFolder folder;
  setenv("XDG_CACHE_HOME", folder.path().c_str(), 1);
  const CostCache cache("a scene"), other("another scene");
  EXPECT_FALSE(cache.read());
  TriedCost cost;
  cost.seconds = 0.1;
  cost.step_growth = 1.5;
  cost.output = 1e12 / 3.;
  cache.write(cost);
  ASSERT_TRUE(CostCache("a scene").read());
  EXPECT_EQ(cache.read()->seconds, 0.1);
  EXPECT_EQ(cache.read()->output, 1e12 / 3.);
  EXPECT_EQ(cache.read()->step_growth, 1.5);
  EXPECT_FALSE(other.read());
}

TEST(CostCache, DoesWithoutAFolder)
{
  setenv("XDG_CACHE_HOME", "/proc/none", 1);
  const CostCache cache("a scene");
  cache.write({});
  EXPECT_FALSE(cache.read());
}

// Figures that a stage lacks by nature need no reason.
TEST(Plan, SaysWhyFiguresOfTheCostAreBlank)
{
  CostEstimate mesh, blast, body;
  mesh.cells = 1000.;
  mesh.memory = mesh.seconds = mesh.output = 1e6;
  body = mesh;
  body.unknowns = 3000.;
  body.seconds = body.output = 0.;
  body.gap = "it deforms";
  blast.gap = "trial runs do not tell";
  const auto lines =
    cost_lines({{"anatomy", mesh}, {"blast", blast}, {"body", body}});
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(lines[5],
            "  blast: cells, unknowns, steps, memory, wall time and output are "
            "unknown: trial runs do not tell");
  EXPECT_EQ(lines[6],
            "  body: steps, wall time and output are unknown: it deforms");
  EXPECT_EQ(lines[7],
            "  all: memory, wall time and output are unknown with those of "
            "blast, body; the others take " +
              duration(mesh.seconds));
  blast = body;
  blast.steps = blast.seconds = blast.output = 10.;
  body.output = body.steps = 10.;
  EXPECT_EQ(cost_lines({{"blast", blast}}).size(), 2U);
  EXPECT_EQ(cost_lines({{"body", body}}).back(),
            "  body: wall time is unknown: it deforms");
}

namespace
{
Assumption item(const double value, const bool is_lower_limit)
{
  return {"gravity",
          "left out",
          "its speed",
          "m/s",
          value,
          2.,
          is_lower_limit,
          "A/B"};
}

bool warns(const std::vector<std::string> &lines)
{
  for (const std::string &line : lines)
    if (line.rfind("WARNING", 0) == 0)
      return true;
  return false;
}
} // namespace

TEST(Plan, WarnsBeyondLimitsAlone)
{
  const double unknown = std::nan("");
  for (const auto &[value, most_fails, least_fails] :
       {std::tuple{1., false, true},
        std::tuple{2., false, false},
        std::tuple{3., true, false},
        std::tuple{unknown, false, false}})
  {
    EXPECT_EQ(item(value, false).fails(), most_fails);
    EXPECT_EQ(item(value, true).fails(), least_fails);
    EXPECT_EQ(warns(plan_lines({item(value, false)})), most_fails);
    EXPECT_EQ(warns(audit_lines({}, {item(value, true)})), least_fails);
  }
  EXPECT_TRUE(plan_lines({}).empty());
  EXPECT_TRUE(audit_lines({}, {}).empty());
}

// The table has both values; two warnings would be two for one choice.
TEST(Plan, WarnsOnceOfAnItem)
{
  const std::vector<Assumption> plan{item(3., false)};
  EXPECT_TRUE(warns(plan_lines(plan)));
  EXPECT_FALSE(warns(audit_lines(plan, {item(3.1, false)})));
  EXPECT_TRUE(warns(audit_lines(plan, {item(4., false)})));
  EXPECT_TRUE(warns(audit_lines({item(1., false)}, {item(3., false)})));
}

// A warning that has not come true is none of the run.
TEST(Plan, ReplacesEstimatesByMeasurements)
{
  const std::vector<Assumption> plan{item(3., false)};
  const std::string begin = "gravity: its speed is ", end = "; see A/B";
  const std::string planned =
    begin + "estimated at 3 m/s, allowed is at most 2 m/s" + end;
  const std::string found =
    begin + "measured at 2.5 m/s, allowed is at most 2 m/s" + end;
  EXPECT_EQ(plan_lines(plan).back(), "WARNING: " + planned);
  using Lines = std::vector<std::string>;
  Assumption audited = item(3., false);
  const auto replaced = [&](const double measured, Lines warnings) {
    audited.value = measured;
    replace_estimates(plan, {audited}, warnings);
    return warnings;
  };
  EXPECT_EQ(replaced(1., {"other", planned}), Lines{"other"});
  EXPECT_EQ(replaced(2.5, {planned, "other"}), (Lines{found, "other"}));
  EXPECT_EQ(replaced(2.5, {planned, found}), Lines{found});
  // A measured figure may be that of the plan.
  EXPECT_EQ(replaced(3., {planned}),
            Lines{begin + "measured at 3 m/s, allowed is at most 2 m/s" + end});
  EXPECT_EQ(replaced(std::nan(""), {planned}), Lines{planned});
  audited.is_estimate = true;
  EXPECT_EQ(replaced(3., {planned}), Lines{planned});
  audited.is_estimate = false;
  // A stage of a scene, which shows little else, takes back what it warned of.
  {
    const LogPart part("blast");
    Log::instance().set_verbose(false);
    testing::internal::CaptureStdout();
    replaced(1., {planned});
    const std::string screen = testing::internal::GetCapturedStdout();
    Log::instance().set_verbose(true);
    EXPECT_NE(screen.find("did not come true"), std::string::npos) << screen;
  }
  Lines alone{planned};
  replace_estimates(plan, {}, alone);
  EXPECT_EQ(alone, Lines{planned});
}

// The plan has warned; what is found counts, where it is known.
TEST(Plan, JudgesByTheEstimateWhatWasNotMeasured)
{
  const Assumption unknown = item(std::nan(""), false);
  const Assumption low = item(1., false), high = item(3., false);
  EXPECT_EQ(holds(unknown, &high), std::optional(false));
  EXPECT_EQ(holds(low, &high), std::optional(true));
  EXPECT_EQ(holds(high, &low), std::optional(false));
  EXPECT_EQ(holds(unknown, &low), std::nullopt);
  EXPECT_EQ(holds(unknown, nullptr), std::nullopt);
  const auto lines = audit_lines({high}, {unknown});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NE(lines[1].find("NO"), std::string::npos) << lines[1];
}

TEST(Plan, NamesEstimateMeasurementAndEntry)
{
  const auto lines = audit_lines({item(1.25, false)}, {item(7.5, false)});
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NE(lines[1].find("1.25 m/s"), std::string::npos) << lines[1];
  EXPECT_NE(lines[1].find("7.5 m/s"), std::string::npos) << lines[1];
  EXPECT_NE(lines[2].find("A/B"), std::string::npos) << lines[2];
}

// The drawing of a report takes time and output; what trial runs alone know is
// unknown of a stage without them, and so of all.
TEST(Plan, SumsWhatIsKnownOfAllStages)
{
  CostEstimate mesh, blast, drawing;
  mesh.memory = 2e8;
  mesh.cells = 1000.;
  mesh.seconds = mesh.output = 1.;
  blast.memory = 7e8;
  blast.seconds = blast.output = 20.;
  drawing.seconds = drawing.output = 12.;
  const auto total =
    total_of({{"anatomy", mesh}, {"blast", blast}, {"report", drawing}});
  EXPECT_EQ(total.memory, 7e8);
  EXPECT_EQ(total.cells, 1000.);
  EXPECT_EQ(total.seconds, 33.);
  const auto unknown = total_of(
    {{"anatomy", mesh}, {"blast", CostEstimate()}, {"report", drawing}});
  EXPECT_EQ(unknown.memory, 0.);
  EXPECT_EQ(unknown.cells, 0.);
  EXPECT_EQ(unknown.seconds, 0.);
  CostEstimate gas;
  gas.steps = gas.seconds = 100.;
  const auto without_cells =
    total_of({{"anatomy", mesh}, {"blast", gas}, {"report", drawing}});
  EXPECT_EQ(without_cells.memory, 0.);
  EXPECT_EQ(without_cells.cells, 0.);
  EXPECT_EQ(without_cells.output, 0.);
  EXPECT_EQ(without_cells.seconds, 113.);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/run/time_parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/first_stage/staged_simulation.h>

#include "../set_entries.h"
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

using namespace contrecoup;
using namespace contrecoup::coupling;

namespace
{
using Lines = std::vector<std::string>;

Lines operator+(Lines a, const Lines &b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}


/// A ball of hot products in an octant.
Lines octant()
{
  return {"Domain/Dimension=3",
          "Domain/Coarse leaves=2, 2, 2",
          "Domain/Upper corner=1, 1, 0.8",
          "Material/Equation of state=jwl in air",
          "Initial state/Kind=regions",
          "Initial state/Region ball/Radius=0.1",
          "Initial state/Region ball/Density=100",
          "Initial state/Region ball/Pressure=1e8",
          "Initial state/Region ball/Products=1",
          "Method/Subcells=4",
          "Adaptation/Active=true",
          "Adaptation/Largest level=2",
          "First stage/Kind=spherical",
          "First stage/Cell size=0.01",
          "First stage/Hand over at=radius",
          "First stage/Radius=0.5",
          "Probes/Points=0.25, 0, 0; 0.15, 0.2, 0.1; 1, 1, 0.8"};
}


/// A charge of TNT instead, that burns on with the air.
Lines charge()
{
  return octant() + Lines{"Initial state/Kind=uniform",
                          "Charges/Charge 1/Radius=0.05",
                          "Charges/Afterburn/Kind=constant",
                          "Charges/Afterburn/End time=5e-4",
                          "First stage/Cell size=0.005",
                          "First stage/Radius=0.4"};
}


/// The same ball above ground, around an axis.
Lines above_ground()
{
  return octant() + Lines{"Domain/Dimension=2",
                          "Domain/Geometry=axisymmetric",
                          "Domain/Upper corner=1.2, 1.2",
                          "Domain/Coarse leaves=2, 2",
                          "Initial state/Region ball/Center=0, 0.5",
                          "First stage/Hand over at=auto",
                          "Probes/Points=0, 0.25; 0.2, 0.6; 1, 1"};
}


/// A ball above ground that stays spherical, then axisymmetric.
Lines three_stages()
{
  return octant() + Lines{"Domain/Upper corner=1.2, 1.2, 1.2",
                          "Initial state/Region ball/Center=0, 0, 0.5",
                          "First stage/Kind=axisymmetric",
                          "First stage/Levels=1",
                          "First stage/Cell size=0.02",
                          "First stage/Spherical cell size=0.01",
                          "First stage/Radius=0.6",
                          "Adaptation/Limit corner/Shape=ball",
                          "Adaptation/Limit corner/Center=1, 1, 1",
                          "Probes/Points=0.25, 0, 0.5; 0.15, 0.2, 0.1; "
                          "1, 1, 1.2"};
}


template <int dim>
void read(const Lines &lines, ParameterHandler &prm)
{
  TimeParameters::declare_parameters(prm);
  StagedSimulation<dim>::declare_parameters(prm);
  set_entries(prm, lines);
}


template <int dim>
std::unique_ptr<StagedSimulation<dim>> make(const Lines &lines)
{
  ParameterHandler prm;
  read<dim>(lines, prm);
  auto simulation = std::make_unique<StagedSimulation<dim>>(MPI_COMM_WORLD);
  simulation->parse_parameters(prm);
  return simulation;
}


std::map<std::string, double> row(const std::vector<NamedValue> &values)
{
  std::map<std::string, double> result;
  for (const NamedValue &value : values)
    result[value.name] = value.value;
  return result;
}


std::string names(const std::vector<NamedValue> &values)
{
  std::string result;
  for (const NamedValue &value : values)
    result += value.name + " [" + value.unit + "] ";
  return result;
}


bool in_second_stage(Simulation &simulation)
{
  return row(simulation.checks()).count("hand_over_time") > 0;
}


/// Continues until @p n steps after the hand-over; all totals stay, no column
/// changes, and probes do not jump.
template <int dim>
void check_run(StagedSimulation<dim> &simulation, const unsigned int n)
{
  simulation.setup();
  const auto first = row(simulation.history());
  const std::string columns = names(simulation.history());
  const std::string probes = names(simulation.probes());
  ASSERT_FALSE(in_second_stage(simulation));
  unsigned int after = 0;
  for (unsigned int step = 0; after < n && step < 2000; ++step)
  {
    const double before = simulation.time();
    simulation.advance(1.);
    EXPECT_GT(simulation.time(), before);
    const auto probe = row(simulation.probes());
    const bool was_second = in_second_stage(simulation);
    simulation.adapt();
    EXPECT_EQ(names(simulation.history()), columns);
    EXPECT_EQ(names(simulation.probes()), probes);
    const auto totals = row(simulation.history());
    const bool afterburn = totals.count("energy_before_afterburn") > 0;
    for (const std::string name :
         {"mass",
          afterburn ? "energy_before_afterburn" : "energy",
          "products_mass"})
      EXPECT_NEAR(totals.at(name), first.at(name), 1e-12 * first.at(name))
        << name << " in step " << step;
    if (in_second_stage(simulation))
      ++after;
    if (in_second_stage(simulation) && !was_second)
    {
      const auto now = row(simulation.probes());
      for (const std::string name :
           {"probe_1_pressure", "probe_2_pressure", "probe_3_pressure"})
        EXPECT_NEAR(now.at(name), probe.at(name), 0.3 * now.at(name)) << name;
    }
  }
  EXPECT_EQ(after, n);
}


/// Takes steps with adaptation.
void steps(Simulation &simulation, const unsigned int n)
{
  for (unsigned int i = 0; i < n; ++i)
  {
    simulation.advance(1.);
    simulation.adapt();
  }
}


std::string scratch()
{
  const auto folder =
    std::filesystem::temp_directory_path() /
    ("contrecoup_staged_simulation_" +
     std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)));
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
  {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  return folder.string();
}
} // namespace


TEST(StagedSimulation, KeepsTotalsFromOneToThreeDimensions)
{
  check_run(*make<3>(octant()), 8);
}

TEST(StagedSimulation, HandsOverABurnedChargeAndItsAfterburn)
{
  const auto simulation = make<3>(charge());
  check_run(*simulation, 4);
  const auto values = row(simulation->history());
  EXPECT_GT(values.at("afterburn_fraction"), 0.05);
  EXPECT_NEAR(values.at("afterburn_energy"),
              values.at("afterburn_fraction") * 3.5e6 *
                values.at("products_mass"),
              1e-9 * values.at("afterburn_energy"));
  // Galerkin schemes can take over what burned in finite volumes.
  check_run(*make<3>(charge() + Lines{"Method/Scheme=discontinuous galerkin",
                                      "Method/Time stepping=ssp rk3",
                                      "Method/Degree=2"}),
            2);
}

TEST(StagedSimulation, KeepsTotalsFromOneToTwoDimensions)
{
  check_run(*make<2>(above_ground()), 20);
}

TEST(StagedSimulation, KeepsTotalsFromTwoToThreeDimensions)
{
  check_run(*make<3>(octant() + Lines{"First stage/Kind=axisymmetric",
                                      "First stage/Levels=2",
                                      "First stage/Cell size=0.02",
                                      "First stage/Radius=0.4"}),
            4);
}

TEST(StagedSimulation, KeepsTotalsFromOneThroughTwoToThreeDimensions)
{
  check_run(*make<3>(three_stages()), 4);
}

TEST(StagedSimulation, RefusesAnAxisymmetricStageThatHasNothingToDo)
{
  const Lines lines = three_stages() + Lines{"First stage/Hand over at=auto",
                                             "Rigid body/Kind=body",
                                             "Body/Kind=shape",
                                             "Body/Shape/Shape=sphere",
                                             "Body/Shape/Size=0.1",
                                             "Body/Shift=0.45, 0, 0.6"};
  // Before the first step.
  EXPECT_THROW(make<3>(lines)->setup(), InputError);
}

TEST(StagedSimulation, HandsOverBeforeTheFrontReachesTheGround)
{
  const auto simulation = make<2>(above_ground());
  simulation->setup();
  while (!in_second_stage(*simulation))
    steps(*simulation, 1);
  const auto values = row(simulation->checks());
  EXPECT_LT(values.at("hand_over_radius"), 0.5);
  EXPECT_GT(values.at("hand_over_radius"), 0.3);
}

TEST(StagedSimulation, HandsOverAtAGivenTimeAndAtOnce)
{
  const auto late = make<3>(
    octant() + Lines{"First stage/Hand over at=time", "First stage/Time=5e-5"});
  late->setup();
  while (!in_second_stage(*late))
    steps(*late, 1);
  EXPECT_NEAR(row(late->checks()).at("hand_over_time"), 5e-5, 1e-17);

  const auto early = make<3>(octant() + Lines{"First stage/Hand over at=time"});
  early->setup();
  EXPECT_TRUE(in_second_stage(*early));
  EXPECT_EQ(early->time(), 0.);
}

TEST(StagedSimulation, RefusesAHandOverAfterTheEnd)
{
  EXPECT_THROW(make<3>(octant() + Lines{"First stage/Hand over at=time",
                                        "First stage/Time=1"}),
               InputError);
}

// As a forecast asks for it of a run that has ended in its first stage.
// By the tables, 0.8535 kg of TNT arrive at 1 m after 0.557 ms.
TEST(StagedSimulation, ExpectsTheFrontWhereTheTablesHaveIt)
{
  const auto simulation =
    make<3>(charge() + Lines{"Time/End time=0.001",
                             "First stage/Hand over at=time",
                             "First stage/Time=0.000557",
                             "Reference/Kind=kingery bulmash",
                             "Reference/Kingery Bulmash/Mass=0.8535"});
  simulation->setup();
  const auto plan = simulation->plan();
  ASSERT_EQ(plan.front().name, "first_stage");
  EXPECT_NEAR(plan.front().value, 1., 0.002);
  EXPECT_TRUE(plan.front().fails());
}

TEST(StagedSimulation, HasAPlanAfterItsTotals)
{
  const auto simulation = make<3>(octant() + Lines{"Rigid body/Kind=body",
                                                   "Body/Kind=shape",
                                                   "Body/Shape/Size=0.1",
                                                   "Body/Shift=0.7, 0.7, 0.5"});
  simulation->setup();
  EXPECT_GT(row(simulation->history()).at("mass"), 0.);
  EXPECT_FALSE(simulation->plan().empty());
}


namespace
{
/// A line of gauges outwards from near a ball of hot products.
Lines with_gauges()
{
  return above_ground() + Lines{"Domain/Upper corner=0.72, 0.96",
                                "Domain/Coarse leaves=18, 24",
                                "Initial state/Region ball/Center=0, 0.48",
                                "Adaptation/Active=false",
                                "First stage/Cell size=0.01",
                                "First stage/Hand over at=radius",
                                "First stage/Radius=0.35",
                                "Probes/Points=",
                                "Probes/Injury=true",
                                "Probes/Lines=0.12, 0.48 : 0.6, 0.48 : 9"};
}


/// Columns of the line of gauges after @p time [s], by name without unit.
std::map<std::string, std::vector<double>> gauge_line(Simulation &run,
                                                      const double time)
{
  run.setup();
  while (run.time() < time)
  {
    run.advance(time - run.time());
    run.adapt();
  }
  const std::string folder = scratch();
  run.write_fields(folder, 0);
  MPI_Barrier(MPI_COMM_WORLD);
  std::ifstream file(folder + "/gauges_line_1.csv");
  std::string line;
  std::getline(file, line);
  const auto names = split(line, ',');
  std::map<std::string, std::vector<double>> columns;
  while (std::getline(file, line))
  {
    const auto words = split(line, ',');
    for (std::size_t i = 0; i < words.size(); ++i)
      columns[names[i].substr(0, names[i].find(' '))].push_back(
        std::stod(words[i]));
  }
  MPI_Barrier(MPI_COMM_WORLD);
  return columns;
}
} // namespace


TEST(StagedSimulation, LinesOfGaugesAreThoseWithoutAFirstStage)
{
  const auto staged = make<2>(with_gauges());
  const auto found = gauge_line(*staged, 1.2e-3);
  ASSERT_TRUE(in_second_stage(*staged));
  ParameterHandler prm;
  TimeParameters::declare_parameters(prm);
  StagedSimulation<2>::declare_parameters(prm);
  set_entries(prm, with_gauges());
  gas::GasSimulation<2> whole(MPI_COMM_WORLD);
  whole.parse_parameters(prm);
  const auto expected = gauge_line(whole, 1.2e-3);
  ASSERT_EQ(found.at("x").size(), 9U);
  for (std::size_t i = 0; i < 9; ++i)
  {
    for (const std::string name :
         {"peak_overpressure", "impulse", "arrival", "duration"})
      EXPECT_NEAR(found.at(name)[i] / expected.at(name)[i], 1., 0.05)
        << name << " at " << found.at("x")[i];
    EXPECT_NEAR(found.at("chest_wall_velocity")[i] /
                  expected.at("chest_wall_velocity")[i],
                1.,
                0.05);
  }
}

TEST(StagedSimulation, GoesOnFromBothStages)
{
  const std::string folder = scratch();
  for (const unsigned int first : {5, 150})
  {
    const auto straight = make<2>(above_ground());
    straight->setup();
    steps(*straight, first);
    EXPECT_EQ(in_second_stage(*straight), first == 150);
    straight->save(folder);
    MPI_Barrier(MPI_COMM_WORLD);
    const auto resumed = make<2>(above_ground());
    resumed->restore(folder);
    EXPECT_EQ(in_second_stage(*resumed), first == 150);
    EXPECT_EQ(resumed->time(), straight->time());
    steps(*straight, 150);
    steps(*resumed, 150);
    EXPECT_EQ(resumed->time(), straight->time());
    EXPECT_EQ(row(resumed->history()), row(straight->history()));
    EXPECT_EQ(row(resumed->probes()), row(straight->probes()));
    auto resumed_values = row(resumed->checks());
    auto straight_values = row(straight->checks());
    // These two are of the run, not of the scene.
    for (const std::string name : {"skipped_updates", "careful_steps"})
    {
      resumed_values.erase(name);
      straight_values.erase(name);
    }
    EXPECT_EQ(resumed_values, straight_values);
  }
}

TEST(StagedSimulation, GoesOnFromEachOfThreeStages)
{
  const std::string folder = scratch();
  const auto straight = make<3>(three_stages());
  straight->setup();
  const auto n_stages_to_come = [](const StagedSimulation<3> &simulation) {
    const auto *const first = simulation.first_stage();
    return first == nullptr ? 0 : (first->is_ready() ? 1 : 2);
  };
  for (const int to_come : {2, 1, 0})
  {
    while (n_stages_to_come(*straight) > to_come)
      steps(*straight, 1);
    steps(*straight, 2);
    ASSERT_EQ(n_stages_to_come(*straight), to_come);
    straight->save(folder);
    MPI_Barrier(MPI_COMM_WORLD);
    const auto resumed = make<3>(three_stages());
    resumed->restore(folder);
    ASSERT_EQ(n_stages_to_come(*resumed), to_come);
    steps(*straight, 3);
    steps(*resumed, 3);
    EXPECT_EQ(resumed->time(), straight->time());
    EXPECT_EQ(row(resumed->history()), row(straight->history()));
    EXPECT_EQ(row(resumed->probes()), row(straight->probes()));
  }
}

TEST(FirstStageLayout, KnowsWhatTheChargeIsBetween)
{
  ParameterHandler prm;
  read<3>(octant() + Lines{"Domain/Lower corner=-1, 0, 0",
                           "Initial state/Region ball/Center=0, 0, 0.3"},
          prm);
  FirstStageParameters parameters;
  parameters.parse_parameters(prm);
  const auto plan = make_first_stage_layout<3>(prm, parameters);
  EXPECT_EQ(plan.domain_fraction, 0.5);
  EXPECT_EQ(plan.side, (std::array<int, 3>{{0, 1, 0}}));
  EXPECT_NEAR(plan.nearest_side, 0.3, 1e-15);
  EXPECT_NEAR(plan.farthest, std::sqrt(1. + 1. + 0.25), 1e-14);
}

TEST(FirstStageLayout, RefusesScenesThatCannotBeginSo)
{
  for (const char *line : {"Initial state/Region ball/Shape=box",
                           "Initial state/Region ball/Center=2, 0, 0",
                           "Initial state/Region other/Center=0.5, 0, 0",
                           "Initial state/Kind=uniform"})
    EXPECT_THROW(make<3>(octant() + Lines{line}), InputError) << line;
  for (const char *line : {"Charges/Charge 1/Shape=box",
                           "Charges/Charge 1/Ignition points=0.01, 0, 0"})
    EXPECT_THROW(make<3>(charge() + Lines{line}), InputError) << line;
  for (const char *line :
       {"First stage/Kind=axisymmetric", "Domain/Geometry=plane"})
    EXPECT_THROW(make<2>(above_ground() + Lines{line}), InputError) << line;
}

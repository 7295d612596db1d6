// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_file.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/run/remaining_time.h>
#include <contrecoup/base/run/time_parameters.h>
#include <contrecoup/coupling/first_stage/staged_simulation.h>

#include "../set_entries.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace contrecoup;
using namespace contrecoup::coupling;

namespace
{
using Lines = std::vector<std::string>;

/// A hot ball next to a cylinder on the ground; leaves get larger at 1.6 ms.
const Lines beside_cylinder = {"Domain/Dimension=3",
                               "Domain/Coarse leaves=4, 2, 2",
                               "Domain/Upper corner=2, 1, 1",
                               "Boundaries/x low=open",
                               "Boundaries/x high=open",
                               "Boundaries/y high=open",
                               "Boundaries/z high=open",
                               "Method/Precision=single",
                               "Method/Subcells=4",
                               "Initial state/Kind=regions",
                               "Initial state/Region ball/Center=0.6, 0, 0.4",
                               "Initial state/Region ball/Radius=0.1",
                               "Initial state/Region ball/Density=20",
                               "Initial state/Region ball/Pressure=3e7",
                               "First stage/Kind=spherical",
                               "First stage/Cell size=0.01",
                               "Rigid body/Kind=body",
                               "Rigid body/Levels=2",
                               "Body/Kind=shape",
                               "Body/Shift=1.3, 0, 0",
                               "Body/Shape/Shape=cylinder",
                               "Body/Shape/Size=0.1, 1.2",
                               "Adaptation/Active=true",
                               "Adaptation/Sensor=blast",
                               "Adaptation/Noise=0.05",
                               "Adaptation/Buffer side=ahead",
                               "Adaptation/Largest level=2",
                               "Adaptation/Limit later/From time=1.6e-3",
                               "Adaptation/Limit later/Largest level=0",
                               "Time/End time=4e-3"};

/// Work that was done, and that was foretold to be left, after each step.
using Course = std::vector<std::pair<double, double>>;

/// By what factor the work left is foretold wrongly, at most, from a @p part of
/// the course's work to nineteen twentieths of it; updates cost one each.
double largest_factor(const Course &course, const double part)
{
  const double work = course.back().first;
  double largest = 1.;
  for (const auto &[done, left] : course)
    if (done > part * work && done < 0.95 * work)
    {
      const double factor = left / (work - done);
      EXPECT_TRUE(std::isfinite(factor)) << "after " << done / work;
      largest = std::max({largest, factor, 1. / factor});
    }
  EXPECT_GT(course.size(), 50U);
  return largest;
}

void parse(const Lines &lines, StagedSimulation<3> &simulation)
{
  ParameterHandler prm;
  TimeParameters::declare_parameters(prm);
  StagedSimulation<3>::declare_parameters(prm);
  set_entries(prm, lines);
  simulation.parse_parameters(prm);
}

/// The courses of the stages of a run until @p end [s], each until it hands
/// over, by the dimension of its mesh.
std::map<unsigned int, Course>
courses_of(const Lines &lines, const double end, const bool with_last_stage)
{
  StagedSimulation<3> simulation(MPI_COMM_WORLD);
  parse(lines, simulation);
  simulation.setup();
  simulation.plan();
  RemainingTime remaining;
  std::map<unsigned int, Course> courses;
  for (unsigned int step = 0; simulation.time() < end; ++step)
  {
    const unsigned int dimension = simulation.dimension();
    if (dimension == 3 && !with_last_stage)
      return courses;
    Course &course = courses[dimension];
    const auto report = simulation.advance(end - simulation.time());
    simulation.adapt();
    const double before = course.empty() ? 0. : course.back().first;
    const double work = before + report.updates;
    remaining.add(report.step_size, report.updates, 1e-9 * report.updates);
    const auto hand_over = simulation.expected_hand_over();
    EXPECT_EQ(hand_over.has_value(), simulation.first_stage() != nullptr);
    if (simulation.dimension() != dimension)
    {
      course.emplace_back(work, 0.);
      continue;
    }
    const double until = hand_over.value_or(end);
    if (step % 8 == 0 || course.empty())
      remaining.set_forecast(simulation.expected_work(until));
    course.emplace_back(work, 1e9 * remaining.left(simulation.time(), until));
  }
  return courses;
}
} // namespace

TEST(ExpectedWork, IsRightFromATenthOfTheLastStageOn)
{
  const auto courses = courses_of(beside_cylinder, 4e-3, true);
  const double factor = largest_factor(courses.at(3), 0.1);
  RecordProperty("factor", std::to_string(factor));
  EXPECT_LT(factor, 1.5);
}

// A spherical stage and an axisymmetric one, each until it hands over. Before
// the blast has swept more mass than it had, its front has another course.
TEST(ExpectedWork, OfFirstStagesIsRightFromAThirdOn)
{
  const Lines above_ground = {"Domain/Dimension=3",
                              "Domain/Coarse leaves=8, 8, 4",
                              "Domain/Lower corner=-1.5, -1.5, 0",
                              "Domain/Upper corner=1.5, 1.5, 1.5",
                              "Method/Subcells=4",
                              "Initial state/Kind=regions",
                              "Initial state/Region ball/Center=0, 0, 0.6",
                              "Initial state/Region ball/Radius=0.03",
                              "Initial state/Region ball/Density=50",
                              "Initial state/Region ball/Pressure=1e9",
                              "First stage/Kind=axisymmetric",
                              "First stage/Cell size=0.01",
                              "First stage/Spherical cell size=0.005",
                              "Time/End time=4e-3"};
  for (const auto &[dimension, course] : courses_of(above_ground, 4e-3, false))
  {
    const double factor = largest_factor(course, 1. / 3.);
    RecordProperty(std::to_string(dimension) + "-D", std::to_string(factor));
    EXPECT_LT(factor, 1.5) << dimension << "-D";
  }
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameter_file.h>
#include <contrecoup/base/parameter_tree.h>
#include <contrecoup/base/remaining_time.h>
#include <contrecoup/base/time_parameters.h>
#include <contrecoup/coupling/staged_simulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace contrecoup;
using namespace contrecoup::coupling;

namespace
{
using Lines = std::vector<std::string>;

/// A hot ball beside a cylinder on the ground; leaves get larger at 1.6 ms.
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

/// By what factor the work left is foretold wrongly, at most, from a tenth of
/// the run's work to nineteen twentieths of it; updates cost one each.
double largest_factor(const Lines &lines)
{
  ParameterHandler prm;
  TimeParameters::declare_parameters(prm);
  StagedSimulation<3>::declare_parameters(prm);
  std::vector<Assignment> assignments;
  for (const std::string &line : lines)
    assignments.push_back(parse_override(line));
  apply_assignments(assignments, prm);
  StagedSimulation<3> simulation(MPI_COMM_WORLD);
  simulation.parse_parameters(prm);
  simulation.setup();
  simulation.plan();
  const double end = 4e-3;
  RemainingTime remaining;
  double work = 0.;
  std::vector<std::pair<double, double>> course;
  for (unsigned int step = 0; simulation.time() < end; ++step)
  {
    const auto report = simulation.advance(end - simulation.time());
    simulation.adapt();
    work += report.updates;
    remaining.add(report.step_size, report.updates, 1e-9 * report.updates);
    if (step % 8 == 0)
      remaining.expect(simulation.expected_work(end));
    course.emplace_back(work, 1e9 * remaining.left(simulation.time(), end));
  }
  double largest = 1.;
  for (const auto &[done, left] : course)
    if (done > 0.1 * work && done < 0.95 * work)
    {
      const double factor = left / (work - done);
      EXPECT_TRUE(std::isfinite(factor)) << "after " << done / work;
      largest = std::max({largest, factor, 1. / factor});
    }
  EXPECT_GT(course.size(), 50U);
  return largest;
}
} // namespace

TEST(ExpectedWork, IsRightFromATenthOfARunOn)
{
  const double factor = largest_factor(beside_cylinder);
  RecordProperty("factor", std::to_string(factor));
  EXPECT_LT(factor, 1.5);
}

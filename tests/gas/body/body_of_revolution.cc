// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "body_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;
using dealii::Tensor;

namespace
{
const double ball_radius = 0.213;

/// A ball on the axis, x = 0, whose leaves are smaller where y is large.
Lines ball_on_axis(const std::string &treatment)
{
  return {"Domain/Geometry=axisymmetric",
          "Rigid body/Kind=body",
          "Rigid body/Treatment=" + treatment,
          "Rigid body/Finer region half/Levels=1",
          "Rigid body/Finer region half/Shape=box",
          "Rigid body/Finer region half/Lower corner=0, 0.5, 0",
          "Rigid body/Finer region half/Upper corner=1, 1, 1",
          "Body/Kind=shape",
          "Body/Shape/Shape=sphere",
          "Body/Shape/Size=" + exactly(ball_radius),
          "Body/Shift=0, 0.48, 0",
          "Domain/Initial refinement=3"};
}


/// Volume of the body, the area of its surface, and the areas of the disks
/// that it shows up and down the axis, less each other.
std::array<double, 3> measures(const GasRun<2> &run)
{
  double gas = 0., area = 0., axial = 0.;
  for_each_gas_point(
    run,
    [&](const unsigned int leaf,
        const unsigned int q,
        const Point<2> &,
        const double part) {
      const double volume = run.cut_leaves.cell_volume({leaf, q});
      const auto box = leaf_box(run.mesh, leaf);
      auto wall = run.cut_leaves.wall({leaf, q});
      for (unsigned int d = 0; d < 2; ++d)
        wall[d] *= volume * run.layout.n / box.extents[d];
      gas += part * volume;
      area += wall.norm();
      axial += wall[1];
    });
  return {{dealii::Utilities::MPI::sum(gas, MPI_COMM_WORLD),
           dealii::Utilities::MPI::sum(area, MPI_COMM_WORLD),
           dealii::Utilities::MPI::sum(axial, MPI_COMM_WORLD)}};
}
} // namespace


TEST(BodyOfRevolution, VolumeAndSurfaceOfABall)
{
  const double pi = dealii::numbers::PI;
  const double ball = 4. / 3. * pi * std::pow(ball_radius, 3);
  const double surface = 4. * pi * ball_radius * ball_radius;
  for (const std::string refinement : {"3", "4", "5"})
  {
    GasRun<2> run(ball_on_axis("embedded") +
                  Lines{"Domain/Initial refinement=" + refinement});
    run.set_state([](const Point<2> &) { return still_air<2>(); });
    const auto [gas, area, axial] = measures(run);
    EXPECT_NEAR((pi - gas) / ball, 1., 2e-4) << refinement;
    EXPECT_NEAR(area / surface, 1., 0.005) << refinement;
    EXPECT_NEAR(axial, 0., 1e-12) << refinement;
  }
}


TEST(BodyOfRevolution, MassAndEnergyStay)
{
  for (const std::string treatment : {"embedded", "staircase"})
  {
    check_conservation<2>(ball_on_axis(treatment), 1);
    check_conservation<2>(ball_on_axis(treatment) + products_in_air(), 1);
    // Off the axis it is a ring.
    check_conservation<2>(
      ball_on_axis(treatment) + Lines{"Body/Shift=0.53, 0.48, 0"}, 1);
  }
}


TEST(BodyOfRevolution, GasAtRestKeepsEveryBit)
{
  for (const std::string treatment : {"embedded", "staircase"})
    check_rest<2>(ball_on_axis(treatment));
}


TEST(BodyOfRevolution, FlowAlongATubeStays)
{
  GasRun<2> run({"Domain/Geometry=axisymmetric",
                 "Rigid body/Kind=half space",
                 "Rigid body/Half space/Shift=0.513, 0, 0",
                 "Rigid body/Finer region half/Levels=1",
                 "Rigid body/Finer region half/Shape=box",
                 "Rigid body/Finer region half/Lower corner=0, 0.55, 0",
                 "Rigid body/Finer region half/Upper corner=1, 1, 1",
                 "Initial state/Background/Density=1.4",
                 "Initial state/Background/Pressure=1",
                 "Initial state/Background/Velocity=0, 1.3",
                 "Boundaries/y low=initial",
                 "Boundaries/y high=initial",
                 "Domain/Initial refinement=3"});
  const GasState<2> state = run.initial_state.value(Point<2>());
  run.set_state([&](const Point<2> &) { return state; });
  run.steps(40);
  EXPECT_LT(largest_change(run, state), 1e-11);
}


TEST(BodyOfRevolution, RanksAgree)
{
  const auto is_driven = [](const Point<2> &p) {
    return p[1] + 0.3 * p[0] < 0.2;
  };
  for (const std::string treatment : {"embedded", "staircase"})
    check_ranks<2>(ball_on_axis(treatment), is_driven);
}

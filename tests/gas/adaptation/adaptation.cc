// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "gas_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
const std::vector<std::string> adaptive = {"Adaptation/Active=true",
                                           "Adaptation/Largest level=4",
                                           "Adaptation/Smallest level=1",
                                           "Domain/Coarse leaves=2, 2, 2",
                                           "Domain/Initial refinement=2"};


/// Uniform gas with a jump in pressure and density at x = @p front.
template <int dim>
StateFunction<dim> jump_at(const double front)
{
  return [front](const Point<dim> &p) {
    GasState<dim> state;
    state.density = p[0] < front ? 4. : 1.;
    state.pressure = p[0] < front ? 5e5 : 1e5;
    return state;
  };
}


/// A hot ball that explodes in cold gas.
template <int dim>
GasState<dim> explosion(const Point<dim> &p)
{
  Point<dim> centre;
  for (unsigned int d = 0; d < dim; ++d)
    centre[d] = 0.45 + 0.05 * d;
  GasState<dim> state;
  state.density = p.distance(centre) < 0.15 ? 4. : 1.;
  state.pressure = p.distance(centre) < 0.15 ? 4e6 : 1e5;
  return state;
}


/// Level of the leaf that holds a point; of all ranks.
template <int dim>
int level_at(const GasRun<dim> &run, const Point<dim> &point)
{
  int level = -1;
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    if (run.mesh.cell(leaf)->point_inside(point))
      level = run.mesh.cell(leaf)->level();
  return dealii::Utilities::MPI::max(level, MPI_COMM_WORLD);
}


template <int dim>
int extreme_level(const GasRun<dim> &run, const bool largest)
{
  int level = largest ? 0 : -100;
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    level = largest ? std::max(level, run.mesh.cell(leaf)->level())
                    : std::max(level, -run.mesh.cell(leaf)->level());
  level = dealii::Utilities::MPI::max(level, MPI_COMM_WORLD);
  return largest ? level : -level;
}


/// Runs an explosion with an adaptation after each second step; mass and
/// energy stay.
template <int dim>
void check_conservation(const std::vector<std::string> &method,
                        const unsigned int n_adaptations)
{
  GasRun<dim> run(adaptive + method);
  run.set_state(explosion<dim>, true);
  const auto before = run.totals();
  unsigned int n_changes = 0;
  for (unsigned int i = 0; i < n_adaptations; ++i)
  {
    n_changes += run.adapt();
    run.steps(2);
  }
  // A line has but two fronts, which cross a leaf in about ten steps.
  EXPECT_GT(n_changes, n_adaptations / (dim == 1 ? 10 : 3));
  const auto after = run.totals();
  for (const std::string name : {"mass", "energy"})
    EXPECT_NEAR(after.at(name), before.at(name), 1e-13 * before.at(name));
  EXPECT_GT(after.at("smallest_density"), 0.);
  EXPECT_GT(after.at("smallest_pressure"), 0.);
  EXPECT_LE(extreme_level(run, true), 4);
  EXPECT_GE(extreme_level(run, false), 1);
}
} // namespace


TEST(Adaptation, AFrontIsRefinedAndTheRestMerged)
{
  for (const auto &method : {finite_volume(4), galerkin(2)})
  {
    GasRun<2> run(adaptive + method);
    for (unsigned int i = 0; i < 6; ++i)
    {
      run.set_state(jump_at<2>(0.27));
      run.adapt();
    }
    EXPECT_EQ(level_at<2>(run, {0.271, 0.31}), 4);
    EXPECT_EQ(level_at<2>(run, {0.269, 0.77}), 4);
    EXPECT_EQ(level_at<2>(run, {0.9, 0.3}), 1);
    EXPECT_EQ(level_at<2>(run, {0.8, 0.8}), 1);
    // The mesh has settled.
    run.set_state(jump_at<2>(0.27));
    EXPECT_FALSE(run.adapt());
  }
}


TEST(Adaptation, TheMeshFollowsAndForgetsTheFront)
{
  GasRun<2> run(adaptive + finite_volume(4));
  for (double front = 0.2; front < 0.85; front += 0.02)
  {
    run.set_state(jump_at<2>(front));
    run.adapt();
    run.set_state(jump_at<2>(front));
    run.adapt();
    if (front > 0.25)
    {
      EXPECT_EQ(level_at<2>(run, {front - 1e-6, 0.3}), 4) << front;
      EXPECT_EQ(level_at<2>(run, {front + 1e-6, 0.3}), 4) << front;
    }
  }
  EXPECT_EQ(level_at<2>(run, {0.2, 0.3}), 1);
  // Without a front the mesh returns to the smallest level.
  for (unsigned int i = 0; i < 6; ++i)
  {
    run.set_state(jump_at<2>(2.));
    run.adapt();
  }
  EXPECT_EQ(extreme_level(run, true), 1);
  run.set_state(jump_at<2>(2.));
  EXPECT_FALSE(run.adapt());
}


TEST(Adaptation, BuffersWidenTheRefinedBand)
{
  std::vector<double> n_leaves;
  for (const std::string buffer : {"0", "1", "2"})
  {
    GasRun<2> run(adaptive + finite_volume(4) +
                  std::vector<std::string>{"Adaptation/Buffer=" + buffer});
    for (unsigned int i = 0; i < 6; ++i)
    {
      run.set_state(jump_at<2>(0.52));
      run.adapt();
    }
    n_leaves.push_back(run.mesh.n_global());
    // As many whole leaves of the finest level lie next to the front's.
    const double h = 1. / 32.;
    EXPECT_EQ(level_at<2>(run, {0.5 + h * (0.5 + std::stoi(buffer)), 0.3}), 4);
  }
  EXPECT_LT(n_leaves[0], n_leaves[1]);
  EXPECT_LT(n_leaves[1], n_leaves[2]);
}


TEST(Adaptation, SensorSeesJumpsAndNotSlopes)
{
  GasRun<2> run(adaptive + finite_volume(8));
  run.set_state([](const Point<2> &p) {
    GasState<2> state;
    state.density = 1. + p[0];
    state.pressure = 1e5 * (1. + p[1]);
    return state;
  });
  run.stepper->update_ghosts(run.field);
  for (const double sensor : run.adaptation->sensors(run.field))
    EXPECT_LT(sensor, 1e-9);

  run.set_state(jump_at<2>(0.55));
  run.stepper->update_ghosts(run.field);
  const auto sensors = run.adaptation->sensors(run.field);
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
  {
    const bool holds_jump =
      std::abs(run.mesh.cell(leaf)->center()[0] - 0.55) < 0.0625;
    EXPECT_GE(sensors[leaf], 0.);
    EXPECT_LE(sensors[leaf], 1.);
    EXPECT_EQ(sensors[leaf] > 0.8, holds_jump);
  }
}


TEST(Adaptation, TwentyAdaptationsConserve)
{
  check_conservation<2>(finite_volume(4), 20);
  check_conservation<2>(galerkin(2), 20);
  check_conservation<2>(
    finite_volume(4) + std::vector<std::string>{"Domain/Geometry=axisymmetric"},
    20);
  check_conservation<3>(finite_volume(2), 4);
}


TEST(Adaptation, LinesConserve)
{
  const std::vector<std::string> spherical = {"Domain/Geometry=spherical"};
  const std::vector<std::string> periodic = {"Domain/Periodic directions=x"};
  for (const auto &method : {finite_volume(4),
                             finite_volume(8) + spherical,
                             finite_volume(4) + periodic,
                             galerkin(2),
                             galerkin(3) + periodic})
    check_conservation<1>(method, 60);
}


TEST(Adaptation, ALineFollowsItsFront)
{
  for (const auto &method : {finite_volume(4), galerkin(2)})
  {
    GasRun<1> run(adaptive + method);
    for (double front = 0.2; front < 0.85; front += 0.02)
    {
      run.set_state(jump_at<1>(front));
      run.adapt();
      run.set_state(jump_at<1>(front));
      run.adapt();
      for (unsigned int leaf = 1; leaf < run.mesh.n_owned(); ++leaf)
        EXPECT_LE(std::abs(run.mesh.cell(leaf)->level() -
                           run.mesh.cell(leaf - 1)->level()),
                  1);
      if (front > 0.25)
      {
        EXPECT_EQ(level_at<1>(run, Point<1>(front - 1e-6)), 4) << front;
        EXPECT_EQ(level_at<1>(run, Point<1>(front + 1e-6)), 4) << front;
      }
    }
    EXPECT_LE(level_at<1>(run, Point<1>(0.2)), 2);
    EXPECT_LT(run.mesh.n_owned(), 16u);
  }
}


TEST(Adaptation, TheNumberOfRanksDoesNotMatter)
{
  const auto make = [](const MPI_Comm communicator) {
    auto run =
      std::make_unique<GasRun<2>>(adaptive + finite_volume(4), communicator);
    run->set_state(explosion<2>, true);
    for (unsigned int i = 0; i < 10; ++i)
    {
      run->adapt();
      run->steps(2);
    }
    return run;
  };
  const auto alone = make(MPI_COMM_SELF);
  const auto together = make(MPI_COMM_WORLD);
  EXPECT_EQ(together->mesh.n_global(), alone->mesh.n_global());
  EXPECT_NEAR(together->time, alone->time, 1e-13 * alone->time);
  const auto all = alone->leaves();
  for (const auto &[name, values] : together->leaves())
  {
    ASSERT_TRUE(all.count(name)) << name;
    const auto &expected = all.at(name);
    for (unsigned int i = 0; i < values.size(); ++i)
      EXPECT_NEAR(values[i], expected[i], 1e-10 * (i < 16 ? 1. : 1e6));
  }
}


TEST(Adaptation, RefineWhereHalvesUpToTheLargestLevel)
{
  GasRun<2> run(adaptive + finite_volume(4));
  const auto wanted = [&](const unsigned int leaf) {
    return run.mesh.cell(leaf)->center().norm() < 0.3;
  };
  unsigned int n_rounds = 0;
  while (run.adaptation->refine_where(wanted) && n_rounds < 10)
    ++n_rounds;
  // One more round than levels: those that balance the octree.
  EXPECT_LE(n_rounds, 3u);
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    EXPECT_TRUE(!wanted(leaf) || run.mesh.cell(leaf)->level() == 4);
  EXPECT_EQ(extreme_level(run, true), 4);
  EXPECT_EQ(level_at<2>(run, {0.9, 0.9}), 2);
}


TEST(Adaptation, BadInputIsRefused)
{
  const auto refusal = [](const std::vector<std::string> &lines) {
    try
    {
      GasRun<2> run(adaptive + lines);
    }
    catch (const InputError &error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal(finite_volume(3)).find("Method/Subcells"),
            std::string::npos);
  EXPECT_EQ(refusal(finite_volume(1)), "");
  EXPECT_NE(refusal({"Adaptation/Coarsen below=0.9"}).find("Coarsen below"),
            std::string::npos);
  EXPECT_NE(refusal({"Adaptation/Smallest level=5"}).find("Smallest level"),
            std::string::npos);
}

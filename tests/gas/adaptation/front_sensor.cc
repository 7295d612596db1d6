// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation/adaptation_pace.h>

#include "gas_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
using Lines = std::vector<std::string>;

const Lines adaptive = {"Adaptation/Active=true",
                        "Adaptation/Sensor=blast",
                        "Adaptation/Noise=0.003",
                        "Adaptation/Smallest level=1",
                        "Adaptation/Largest level=4",
                        "Domain/Initial refinement=3"};

GasState<2> ambient()
{
  GasState<2> state;
  state.density = 1.225;
  state.pressure = 101325.;
  return state;
}


/// A weak shock of half a percent at x = 0.52, moving to the right, four
/// subcells wide.
GasState<2> weak_front(const Point<2> &p)
{
  GasState<2> state = ambient();
  const double rise =
    0.005 * 0.5 * (1. - std::tanh((p[0] - 0.52) / (2. / 64.)));
  const double speed = std::sqrt(1.4 * state.pressure / state.density);
  state.velocity[0] = rise * speed / 1.4;
  state.density *= 1. + rise / 1.4;
  state.pressure *= 1. + rise;
  return state;
}


/// Edges of hot gas at rest, and a shear layer: no pressure fronts.
GasState<2> contacts(const Point<2> &p)
{
  GasState<2> state = ambient();
  if (p[0] < 0.52)
    state.density = 0.1;
  state.velocity[1] = 100. * std::tanh((p[0] - 0.52) / 0.02);
  const double shear = 1. - std::pow(std::tanh((p[0] - 0.52) / 0.02), 2);
  state.pressure *= 1. + 0.01 * shear * std::sin(60. * p[1]);
  return state;
}


/// Largest sensor of leaves whose centre is within and beyond 1/16 of the
/// line x = 0.52, of all ranks.
std::array<double, 2> near_and_far(const StateFunction<2> &state,
                                   const Lines &lines = {})
{
  GasRun<2> run(adaptive + finite_volume(8) + lines);
  run.set_state(state);
  run.stepper->update_ghosts(run.field);
  const auto sensors = run.adaptation->sensors(run.field);
  std::array<double, 2> largest = {{0., 0.}};
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
  {
    const bool far = std::abs(run.mesh.cell(leaf)->center()[0] - 0.52) > 0.13;
    largest[far] = std::max(largest[far], sensors[leaf]);
  }
  for (double &value : largest)
    value = dealii::Utilities::MPI::max(value, MPI_COMM_WORLD);
  return largest;
}
} // namespace


TEST(FrontSensor, SeesAFrontOfHalfAPercent)
{
  const auto blast = near_and_far(weak_front);
  EXPECT_GT(blast[0], 0.5);
  EXPECT_LT(blast[1], 0.1);
  const auto bend = near_and_far(
    weak_front,
    {"Adaptation/Sensor=density and pressure", "Adaptation/Noise=0.02"});
  EXPECT_LT(bend[0], 0.1);
}


TEST(FrontSensor, SeesNoContactsAndNoVortices)
{
  EXPECT_LT(near_and_far(contacts)[0], 0.2);
  EXPECT_GT(
    near_and_far(contacts, {"Adaptation/Sensor=density and pressure"})[0], 0.5);
  // Nor fans, where the gas expands.
  EXPECT_LT(near_and_far([](const Point<2> &p) {
              GasState<2> state = weak_front(p);
              state.velocity *= -1.;
              return state;
            })[0],
            1e-12);
}


namespace
{
/// Steps until adaptation is due, when fronts run that share in each.
unsigned int steps_until_due(const AdaptationParameters &parameters,
                             const double front_travel = 1.)
{
  AdaptationPace pace(parameters);
  unsigned int result = 0;
  for (; !pace.is_due(); ++result)
    pace.add_step(front_travel);
  return result;
}


struct Followed
{
  unsigned int leaves = 0; ///< at the end
  unsigned int steps = 0;
};

/// Six times as many steps as the buffer allows between two adaptations.
Followed follow_a_front(const Lines &lines)
{
  GasRun<2> run(adaptive + finite_volume(8) + Lines{"Adaptation/Interval=0"} +
                lines);
  AdaptationParameters parameters = run.adaptation_parameters;
  parameters.find_buffer_steps(
    run.scheme.cfl * run.scheme.stability_limit(), 2, 8);
  EXPECT_EQ(steps_until_due(parameters), 26u);
  const StateFunction<2> start = [](const Point<2> &p) {
    GasState<2> state = ambient();
    if (p[0] < 0.2)
      state.pressure *= 20.;
    return state;
  };
  for (unsigned int i = 0; i < 5; ++i)
  {
    run.set_state(start);
    run.adapt();
  }
  run.set_state(start);
  run.adapt();
  Followed result;
  for (unsigned int round = 0; round < 6; ++round)
  {
    AdaptationPace pace(parameters);
    for (; !pace.is_due(); ++result.steps)
    {
      pace.add_step(run.front_travel());
      run.steps(1);
    }
    // Where the gas moves farthest to the right the leaves are fine.
    std::array<double, 2> farthest = {{0., 0.}};
    for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    {
      const auto values = run.field.leaf(leaf);
      double &place = farthest[run.mesh.cell(leaf)->level() >= 4];
      for (unsigned int q = 0; q < run.layout.n_points; ++q)
        if (values[run.layout.n_points + q] > 10.)
          place = std::max(place, run.mesh.cell(leaf)->center()[0]);
    }
    for (double &place : farthest)
      place = dealii::Utilities::MPI::max(place, MPI_COMM_WORLD);
    EXPECT_GT(farthest[1], farthest[0]) << round;
    EXPECT_GT(farthest[1], 0.2 + 900. * run.time - 1. / 16.);
    run.adapt();
  }
  result.leaves = run.mesh.n_global();
  return result;
}
} // namespace


TEST(FrontSensor, AFrontStaysInFineLeavesBetweenAdaptations)
{
  const Followed all_around = follow_a_front({});
  const Followed ahead = follow_a_front({"Adaptation/Buffer side=ahead"});
  EXPECT_LE(ahead.leaves, all_around.leaves);
  EXPECT_EQ(ahead.steps, 6u * 26u);
}


TEST(FrontSensor, StepsOfSmallLeavesAtABodyAskForFewAdaptations)
{
  // Its leaves are a sixteenth of those that fronts may have, and sound is some
  // five times as fast behind the front as in the air around the body.
  const Followed front = follow_a_front({"Adaptation/Buffer side=ahead",
                                         "Rigid body/Kind=body",
                                         "Rigid body/Levels=5",
                                         "Body/Kind=shape",
                                         "Body/Shape/Shape=sphere",
                                         "Body/Shape/Size=0.02",
                                         "Body/Shift=0.5, 0.5, 0"});
  EXPECT_GT(front.steps, 2u * 6u * 26u);
}


TEST(FrontSensor, KnowsWhereFrontsRunTo)
{
  // A weak front at x = 0.54 runs to the right; only there the leaves beyond
  // those that see it stay fine.
  const auto leaves = [](const std::string &side) {
    GasRun<2> run(
      adaptive + finite_volume(8) +
      Lines{"Adaptation/Buffer side=" + side, "Domain/Initial refinement=4"});
    run.set_state([](const Point<2> &p) {
      return weak_front({p[0] - 0.02, p[1]});
    });
    run.adapt();
    std::array<double, 2> finest = {{1., 0.}};
    for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
      if (run.mesh.cell(leaf)->level() == 4)
      {
        const double x = run.mesh.cell(leaf)->center()[0];
        finest[0] = std::min(finest[0], x);
        finest[1] = std::max(finest[1], x);
      }
    return std::array<double, 2>{
      {dealii::Utilities::MPI::min(finest[0], MPI_COMM_WORLD),
       dealii::Utilities::MPI::max(finest[1], MPI_COMM_WORLD)}};
  };
  const auto all = leaves("all"), ahead = leaves("ahead");
  EXPECT_GT(ahead[0], all[0]);
  EXPECT_EQ(ahead[1], all[1]);
}


TEST(FrontSensor, IntervalsFitTheBuffer)
{
  AdaptationParameters parameters;
  const auto fitted = [&](const unsigned int interval,
                          const unsigned int buffer,
                          const unsigned int dim,
                          const unsigned int n_points) {
    parameters.interval = interval;
    parameters.buffer = buffer;
    parameters.find_buffer_steps(0.4 / n_points, dim, n_points);
    return steps_until_due(parameters);
  };
  EXPECT_EQ(fitted(0, 1, 1, 8), 17u);
  EXPECT_EQ(fitted(0, 1, 2, 8), 26u);
  EXPECT_EQ(fitted(0, 1, 3, 8), 32u);
  EXPECT_EQ(fitted(0, 2, 3, 8), 69u);
  EXPECT_EQ(fitted(5, 1, 3, 8), 5u);
  EXPECT_EQ(fitted(50, 1, 3, 8), 32u);
  EXPECT_EQ(fitted(5, 1, 2, 1), 1u);
  EXPECT_EQ(fitted(5, 0, 3, 8), 1u);
}


TEST(FrontSensor, IntervalsAreLongerWhereTheBodyAloneHasSmallLeaves)
{
  AdaptationParameters parameters;
  parameters.find_buffer_steps(0.4 / 4, 3, 4);
  parameters.interval = 0;
  EXPECT_EQ(steps_until_due(parameters), 13u);
  EXPECT_EQ(steps_until_due(parameters, 0.5), 27u);
  EXPECT_EQ(steps_until_due(parameters, 0.125), 111u);
  parameters.interval = 20;
  EXPECT_EQ(steps_until_due(parameters, 0.5), 20u);
  // Never beyond what the fastest step so far asks for.
  parameters.interval = 0;
  AdaptationPace pace(parameters);
  for (unsigned int i = 0; i < 20; ++i)
    pace.add_step(0.5);
  EXPECT_FALSE(pace.is_due());
  for (unsigned int i = 0; i < 3; ++i)
    pace.add_step(1.);
  EXPECT_TRUE(pace.is_due());
  pace.restart(0.);
  EXPECT_FALSE(pace.is_due());
}


TEST(SizeLimits, NarrowLevelsByPlaceAndTime)
{
  GasRun<2> run({"Domain/Initial refinement=1",
                 "Adaptation/Active=true",
                 "Adaptation/Largest level=6",
                 "Adaptation/Limit later/From time=3e-3",
                 "Adaptation/Limit later/Largest level=4",
                 "Adaptation/Limit behind/Shape=ball",
                 "Adaptation/Limit behind/Center=0.5, 0.5",
                 "Adaptation/Limit behind/Radius=0.1",
                 "Adaptation/Limit behind/Radius growth=100",
                 "Adaptation/Limit behind/From time=1e-3",
                 "Adaptation/Limit behind/Until time=4e-3",
                 "Adaptation/Limit behind/Largest level=2",
                 "Adaptation/Limit ground/Shape=box",
                 "Adaptation/Limit ground/Lower corner=0, 0",
                 "Adaptation/Limit ground/Upper corner=1, 0.1",
                 "Adaptation/Limit ground/Smallest level=3"});
  const SizeLimits &limits = run.adaptation_parameters.limits;
  const auto levels = [&](const double x, const double y, const double time) {
    const auto result = limits.levels(Point<2>(x, y), time, {1, 6});
    return std::make_pair(result.min_level, result.max_level);
  };
  using Pair = std::pair<unsigned int, unsigned int>;
  EXPECT_EQ(levels(0.5, 0.5, 0.), Pair(1, 6));
  EXPECT_EQ(levels(0.5, 0.5, 1e-3), Pair(1, 2));
  EXPECT_EQ(levels(0.65, 0.5, 1e-3), Pair(1, 6));
  EXPECT_EQ(levels(0.65, 0.5, 2e-3), Pair(1, 2));
  EXPECT_EQ(levels(0.5, 0.9, 3e-3), Pair(1, 4));
  EXPECT_EQ(levels(0.5, 0.5, 4e-3), Pair(1, 4));
  EXPECT_EQ(levels(0.5, 0.05, 0.), Pair(3, 6));
}


TEST(SizeLimits, HoldAroundSeveralPoints)
{
  const Lines balls = {"Domain/Initial refinement=1",
                       "Adaptation/Active=true",
                       "Adaptation/Largest level=6",
                       "Adaptation/Limit far/Shape=outside of ball",
                       "Adaptation/Limit far/Center=0.2, 0.2; 0.8, 0.5",
                       "Adaptation/Limit far/Radius=0.1",
                       "Adaptation/Limit far/Largest level=3"};
  GasRun<2> run(balls);
  const auto most = [&](const double x, const double y) {
    return run.adaptation_parameters.limits.levels(Point<2>(x, y), 0., {1, 6})
      .max_level;
  };
  EXPECT_EQ(most(0.25, 0.2), 6u);
  EXPECT_EQ(most(0.8, 0.55), 6u);
  EXPECT_EQ(most(0.2, 0.5), 3u);
  EXPECT_EQ(most(0.8, 0.2), 3u);
  // A coarse leaf next to a ball may be halved until its parts are outside.
  const auto allowed = [&](const double corner_distance) {
    return run.adaptation_parameters.limits
      .levels(Point<2>(0.4, 0.4), 0., {1, 6}, corner_distance)
      .max_level;
  };
  EXPECT_EQ(allowed(0.2), 6u);
  EXPECT_EQ(allowed(0.1), 3u);

  EXPECT_THROW(
    GasRun<2>(balls + Lines{"Adaptation/Limit far/Center=0.2, 0.2; 0.8"}),
    InputError);
  EXPECT_THROW(GasRun<2>(balls + Lines{"Adaptation/Limit far/Center="}),
               InputError);
}


TEST(SizeLimits, MakeLeavesFineAndCoarse)
{
  const Lines lines = {"Domain/Initial refinement=2",
                       "Adaptation/Active=true",
                       "Adaptation/Largest level=4",
                       "Adaptation/Limit low/Shape=box",
                       "Adaptation/Limit low/Lower corner=0, 0",
                       "Adaptation/Limit low/Upper corner=1, 0.2",
                       "Adaptation/Limit low/Smallest level=4",
                       "Adaptation/Limit low/Until time=1",
                       "Adaptation/Limit later/From time=1",
                       "Adaptation/Limit later/Largest level=1"};
  GasRun<2> run(finite_volume(4) + lines);
  const auto finest = [&]() {
    int level = 0;
    for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
      level = std::max(level, run.mesh.cell(leaf)->level());
    return dealii::Utilities::MPI::max(level, MPI_COMM_WORLD);
  };
  const auto adapt = [&](const double time) {
    for (unsigned int i = 0; i < 4; ++i)
    {
      run.set_state([](const Point<2> &) { return ambient(); });
      run.stepper->update_ghosts(run.field);
      run.adaptation->adapt(run.field, time);
    }
  };
  adapt(0.);
  EXPECT_EQ(finest(), 4);
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    EXPECT_EQ(run.mesh.cell(leaf)->level() == 4,
              run.mesh.cell(leaf)->center()[1] < 0.25)
      << run.mesh.cell(leaf)->center();
  adapt(1.);
  EXPECT_LE(finest(), 1);
}


TEST(SizeLimits, BadInputIsRefused)
{
  const auto refusal = [](const Lines &lines) {
    try
    {
      GasRun<2> run(lines);
    }
    catch (const InputError &error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal({"Adaptation/Limit a/Smallest level=5",
                     "Adaptation/Limit a/Largest level=4"})
              .find("Adaptation/Limit a: Smallest level"),
            std::string::npos);
  EXPECT_NE(refusal({"Adaptation/Active=true", "Adaptation/Buffer side=ahead"})
              .find("Buffer side = ahead needs"),
            std::string::npos);
  EXPECT_NE(refusal({"Adaptation/Limit a/From time=2",
                     "Adaptation/Limit a/Until time=1"})
              .find("From time"),
            std::string::npos);
  EXPECT_NE(
    refusal({"Adaptation/Limit a/Shape=ball", "Adaptation/Limit a/Center=1"})
      .find("Center needs 2 numbers"),
    std::string::npos);
}


TEST(Balance, RanksShareTheActiveLeaves)
{
  // A burst in one corner: leaves that it has not reached weigh little.
  GasRun<2> run(finite_volume(8) + Lines{"Domain/Initial refinement=5",
                                         "Adaptation/Active=true",
                                         "Adaptation/Smallest level=5",
                                         "Adaptation/Largest level=6"});
  run.set_state([](const Point<2> &p) {
    GasState<2> state = ambient();
    if (p.norm() < 0.3)
      state.pressure *= 50.;
    return state;
  });
  for (unsigned int i = 0; i < 4; ++i)
  {
    run.steps(2);
    run.stepper->update_ghosts(run.field);
    if (run.adaptation->adapt(run.field, run.time, run.quiet_leaves.get()))
      run.stepper->reinit(run.field);
  }
  const auto &quiet = *run.quiet_leaves;
  double mine = 0.;
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    mine += quiet.is_active(leaf / run.mesh.width()) ? 1. : 0.;
  const double all = dealii::Utilities::MPI::sum(mine, MPI_COMM_WORLD);
  const double most = dealii::Utilities::MPI::max(mine, MPI_COMM_WORLD);
  EXPECT_LT(all, 0.6 * run.mesh.n_global());
  EXPECT_LT(most * dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
            1.3 * all);
}

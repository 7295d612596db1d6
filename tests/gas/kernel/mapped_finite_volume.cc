// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "mapped_run.h"

namespace contrecoup::gas
{
namespace
{
  const Lines method = {"Method/Subcells=4"};
} // namespace

TEST(MappedFiniteVolume, RestStaysToTheLastBit)
{
  for (const Lines &lines : ball_and_shell<2>())
    expect_rest<2>(lines + method);
  for (const Lines &lines : ball_and_shell<3>())
    expect_rest<3>(lines + method);
}

TEST(MappedFiniteVolume, UniformFlowStays)
{
  for (const Lines &lines : ball_and_shell<2>())
    expect_wind<2>(lines + method);
  for (const Lines &lines : ball_and_shell<3>())
    expect_wind<3>(lines + method);
}

TEST(MappedFiniteVolume, ClosedBallKeepsMassAndEnergy)
{
  expect_conservation<2>(ball_and_shell<2>()[0] + method);
  expect_conservation<3>(ball_and_shell<3>()[0] + method);
}

TEST(MappedFiniteVolume, ProductsInAirAreKept)
{
  for (const std::string limiter : {"none", "venkatakrishnan"})
  {
    const auto [before, after] =
      run<3>(ball_and_shell<3>()[0] + method + charge +
               Lines{"Method/Gradient limiter=" + limiter},
             20);
    for (const std::string name : {"mass", "energy", "products_mass"})
      EXPECT_NEAR(after.at(name) / before.at(name), 1., 1e-13) << name;
    EXPECT_GT(after.at("smallest_pressure"), 0.);
    EXPECT_GT(after.at("kinetic_energy"), 1e3);
  }
}

TEST(MappedFiniteVolume, GradientLimitersConserveAndStaySound)
{
  for (const std::string name : {"barth jespersen", "venkatakrishnan"})
  {
    const Lines limiter = method + Lines{"Method/Gradient limiter=" + name};
    expect_conservation<2>(ball_and_shell<2>()[0] + limiter);
    expect_conservation<3>(ball_and_shell<3>()[0] + limiter);
    expect_wind<3>(ball_and_shell<3>()[0] + limiter);
  }
}

// The same box, once by the kernel for boxes.
TEST(MappedFiniteVolume, AgreesWithTheKernelForBoxes)
{
  const Lines mapped =
    mesh(3, "subdivided_hyper_rectangle", "2,1,1:-1,-1,-1:3,1,1:true", 1) +
    method;
  const Lines box = {"Domain/Dimension=3",
                     "Domain/Lower corner=-1,-1,-1",
                     "Domain/Upper corner=3,1,1",
                     "Domain/Coarse leaves=2,1,1",
                     "Domain/Initial refinement=1",
                     "Method/Subcells=4"};
  const Totals a = run<3>(mapped + explosion, 15).second;
  const Totals b = run<3>(box + explosion, 15).second;
  for (const auto &[name, value] : b)
    EXPECT_NEAR(a.at(name), value, 1e-11 * (1. + std::abs(value))) << name;
}

TEST(MappedFiniteVolume, WhatNeedsBoxesIsRefused)
{
  const Lines lines = mesh(2, "hyper_ball", "0,0:1:true", 1) + rest;
  for (const std::string line :
       {"Adaptation/Active=true", "Pictures/Planes=all"})
    EXPECT_THROW(run<2>(lines + Lines{line}, 1), InputError) << line;
  EXPECT_THROW(
    run<2>({"Domain/Dimension=2", "Method/Gradient limiter=barth jespersen"},
           1),
    InputError);
}

TEST(MappedFiniteVolume, ProbesOutsideAreRefused)
{
  const Lines lines = mesh(2, "hyper_ball", "0,0:1:true", 1) + rest;
  EXPECT_NO_THROW(run<2>(lines + Lines{"Probes/Points=0.1,0.2"}, 1));
  EXPECT_THROW(run<2>(lines + Lines{"Probes/Points=0.9,0.9"}, 1), InputError);
}
} // namespace contrecoup::gas

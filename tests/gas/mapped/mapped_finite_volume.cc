// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "mapped_hanging_run.h"

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

TEST(MappedFiniteVolume, RestBesideHangingFacesStaysToTheLastBit)
{
  for (const std::string subcells : {"1", "2", "4"})
  {
    const Lines scheme = {"Method/Subcells=" + subcells,
                          std::string("Method/Reconstruction=") +
                            (subcells == "1" ? "constant" : "linear"),
                          "Method/Skip quiet leaves=false"};
    for (const Lines &lines : with_hanging_faces<2>())
      expect_rest<2>(lines + scheme);
    for (const Lines &lines : with_hanging_faces<3>())
      expect_rest<3>(lines + scheme);
  }
}

TEST(MappedFiniteVolume, UniformFlowPassesHangingFaces)
{
  for (const std::string subcells : {"1", "4"})
  {
    const Lines scheme = {"Method/Subcells=" + subcells,
                          std::string("Method/Reconstruction=") +
                            (subcells == "1" ? "constant" : "linear")};
    for (const Lines &lines : with_hanging_faces<2>())
      expect_wind<2>(lines + scheme);
    for (const Lines &lines : with_hanging_faces<3>())
      expect_wind<3>(lines + scheme);
  }
  expect_wind<3>(with_hanging_faces<3>()[2] + method +
                 Lines{"Method/Gradient limiter=barth jespersen"});
}

TEST(MappedFiniteVolume, HangingFacesKeepMassAndEnergy)
{
  expect_conservation<2>(with_hanging_faces<2>()[0] + method);
  for (const Lines &lines :
       {with_hanging_faces<3>()[0], with_hanging_faces<3>()[2]})
    expect_conservation<3>(lines + method);
}

TEST(MappedFiniteVolume, HangingFacesWorkInAnyOrientation)
{
  expect_the_same_when_turned(method);
}

TEST(MappedFiniteVolume, HangingFacesAreAlikeOnAnyNumberOfRanks)
{
  for (const Lines &lines : with_hanging_faces<2>())
    EXPECT_EQ(difference_between_ranks<2>(lines + method, 10), 0.);
  for (const Lines &lines : with_hanging_faces<3>())
    EXPECT_EQ(difference_between_ranks<3>(lines + method, 10), 0.);
}

TEST(MappedFiniteVolume, ProductsPassHangingFaces)
{
  const auto [before, after] =
    run<3>(with_hanging_faces<3>()[0] + method + charge, 20);
  for (const std::string name : {"mass", "energy", "products_mass"})
    EXPECT_NEAR(after.at(name) / before.at(name), 1., 1e-13) << name;
  EXPECT_GT(after.at("smallest_pressure"), 0.);
  EXPECT_GT(after.at("kinetic_energy"), 1e3);
}

// In single precision a uniform flow keeps seven digits, and rest every bit.
TEST(MappedFiniteVolume, SinglePrecision)
{
  const Lines single =
    method + Lines{"Method/Precision=single", "Method/Skip quiet leaves=false"};
  std::vector<Lines> meshes = with_hanging_faces<3>();
  meshes.push_back(ball_and_shell<3>()[1]);
  for (const Lines &lines : meshes)
  {
    expect_rest<3>(lines + single);
    expect_wind<3>(lines + single, 1e-6);
    EXPECT_EQ(difference_between_ranks<3>(lines + single, 10), 0.);
  }
  const Lines &ball = meshes[0];
  expect_conservation<3>(ball + single, 1e-6);
  const Totals a = run<3>(ball + method + explosion, 20).second;
  const Totals b = run<3>(ball + single + explosion, 20).second;
  for (const auto &[name, value] : a)
    EXPECT_NEAR(b.at(name), value, 1e-5 * (1. + std::abs(value))) << name;
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
  for (const Lines &fine : {Lines(), finer("-1,-1,-1", "0.1,1,0.1", 2)})
  {
    const Totals a = run<3>(mapped + fine + explosion, 15).second;
    const Totals b = run<3>(box + fine + explosion, 15).second;
    for (const auto &[name, value] : b)
      EXPECT_NEAR(a.at(name), value, 1e-11 * (1. + std::abs(value))) << name;
  }
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

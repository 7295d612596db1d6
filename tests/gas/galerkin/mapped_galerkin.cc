// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "mapped_hanging_run.h"

namespace contrecoup::gas
{
namespace
{
  Lines galerkin_scheme(const unsigned int degree,
                        const std::string &blending = "true")
  {
    return {"Method/Scheme=discontinuous galerkin",
            "Method/Time stepping=ssp rk3",
            "Method/Degree=" + std::to_string(degree),
            "Method/Blending=" + blending};
  }

  const Lines mist = {"Initial state/Kind=regions",
                      "Initial state/Background/Density=1.4",
                      "Initial state/Background/Velocity=0.3,-0.5",
                      "Initial state/Background/Pressure=1",
                      "Initial state/Region charge/Radius=0.4",
                      "Initial state/Region charge/Density=2.8",
                      "Initial state/Region charge/Velocity=0.3,-0.5",
                      "Initial state/Region charge/Pressure=1",
                      "Boundaries/By id=0: initial"};
} // namespace

TEST(MappedGalerkin, RestStaysToTheLastBit)
{
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    for (const Lines &lines : ball_and_shell<2>())
      expect_rest<2>(lines + galerkin_scheme(degree));
    for (const Lines &lines : ball_and_shell<3>())
      expect_rest<3>(lines + galerkin_scheme(degree));
  }
}

TEST(MappedGalerkin, UniformFlowStays)
{
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    for (const Lines &lines : ball_and_shell<2>())
      expect_wind<2>(lines + galerkin_scheme(degree));
    for (const Lines &lines : ball_and_shell<3>())
      expect_wind<3>(lines + galerkin_scheme(degree));
  }
}

// A blob of denser gas drifts with the wind: leaves are troubled and blended,
// velocity and pressure stay uniform.
TEST(MappedGalerkin, BlendingKeepsVelocityAndPressure)
{
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    const auto totals =
      run<3>(ball_and_shell<3>()[0] + galerkin_scheme(degree) + mist, 5).second;
    EXPECT_NEAR(totals.at("smallest_pressure"), 1., 1e-11);
    EXPECT_NEAR(totals.at("largest_pressure"), 1., 1e-11);
    EXPECT_NEAR(
      totals.at("kinetic_energy") / totals.at("mass"), 0.5 * 0.34, 1e-11);
    EXPECT_GT(totals.at("largest_density"), 2.);
  }
}

TEST(MappedGalerkin, ClosedBallKeepsMassAndEnergy)
{
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    expect_conservation<2>(ball_and_shell<2>()[0] + galerkin_scheme(degree));
    expect_conservation<3>(ball_and_shell<3>()[0] + galerkin_scheme(degree));
  }
}

TEST(MappedGalerkin, RestBesideHangingFacesStaysToTheLastBit)
{
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    const Lines scheme =
      galerkin_scheme(degree) + Lines{"Method/Skip quiet leaves=false"};
    for (const Lines &lines : with_hanging_faces<2>())
      expect_rest<2>(lines + scheme);
    for (const Lines &lines : with_hanging_faces<3>())
      expect_rest<3>(lines + scheme);
  }
}

TEST(MappedGalerkin, UniformFlowPassesHangingFaces)
{
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    for (const Lines &lines : with_hanging_faces<2>())
      expect_wind<2>(lines + galerkin_scheme(degree));
    for (const Lines &lines : with_hanging_faces<3>())
      expect_wind<3>(lines + galerkin_scheme(degree));
  }
}

TEST(MappedGalerkin, HangingFacesKeepMassAndEnergy)
{
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    SCOPED_TRACE(degree);
    const Lines scheme = galerkin_scheme(degree);
    expect_conservation<2>(with_hanging_faces<2>()[0] + scheme, 1e-13, 40);
    for (const Lines &lines :
         {with_hanging_faces<3>()[0], with_hanging_faces<3>()[2]})
      expect_conservation<3>(lines + scheme, 1e-13, 40);
  }
}

TEST(MappedGalerkin, HangingFacesWorkInAnyOrientation)
{
  for (const unsigned int degree : {1U, 2U})
    expect_the_same_when_turned(galerkin_scheme(degree, "false"));
}

TEST(MappedGalerkin, HangingFacesAreAlikeOnAnyNumberOfRanks)
{
  for (const unsigned int degree : {1U, 3U})
  {
    const Lines scheme = galerkin_scheme(degree, "false");
    for (const Lines &lines : with_hanging_faces<2>())
      EXPECT_LT(difference_between_ranks<2>(lines + scheme, 10), 1e-13);
    for (const Lines &lines : with_hanging_faces<3>())
      EXPECT_LT(difference_between_ranks<3>(lines + scheme, 10), 1e-13);
  }
}

// In single precision a uniform flow keeps seven digits, and rest every bit.
TEST(MappedGalerkin, SinglePrecision)
{
  std::vector<Lines> meshes = with_hanging_faces<3>();
  meshes.push_back(ball_and_shell<3>()[1]);
  for (const Lines &lines : meshes)
    for (const unsigned int degree : {1U, 2U})
    {
      const Lines single =
        galerkin_scheme(degree) +
        Lines{"Method/Precision=single", "Method/Skip quiet leaves=false"};
      expect_rest<3>(lines + single);
      expect_wind<3>(lines + single, 1e-6);
    }
  expect_conservation<3>(
    meshes[0] + galerkin_scheme(2) + Lines{"Method/Precision=single"}, 1e-6);
}

TEST(MappedGalerkin, ProductsInAirAreKept)
{
  const auto [before, after] =
    run<3>(ball_and_shell<3>()[0] + galerkin_scheme(2) + charge, 20);
  for (const std::string name : {"mass", "energy", "products_mass"})
    EXPECT_NEAR(after.at(name) / before.at(name), 1., 1e-13) << name;
  EXPECT_GT(after.at("smallest_pressure"), 0.);
  EXPECT_GT(after.at("kinetic_energy"), 1e3);
}

// The same box, once by the kernel for boxes.
TEST(MappedGalerkin, AgreesWithTheKernelForBoxes)
{
  const Lines mapped =
    mesh(3, "subdivided_hyper_rectangle", "2,1,1:-1,-1,-1:3,1,1:true", 1);
  const Lines box = {"Domain/Dimension=3",
                     "Domain/Lower corner=-1,-1,-1",
                     "Domain/Upper corner=3,1,1",
                     "Domain/Coarse leaves=2,1,1",
                     "Domain/Initial refinement=1"};
  const Lines mild = {"Initial state/Kind=vortex",
                      "Initial state/Vortex/Strength=2",
                      "Initial state/Vortex/Radius=0.5",
                      "Initial state/Vortex/Velocity=0.5,0.2,0.1"};
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    const Lines method = galerkin_scheme(degree, "false") + mild;
    const Totals a = run<3>(mapped + method, 15).second;
    const Totals b = run<3>(box + method, 15).second;
    for (const auto &[name, value] : b)
      EXPECT_NEAR(a.at(name), value, 1e-11 * (1. + std::abs(value))) << name;
  }
}
} // namespace contrecoup::gas

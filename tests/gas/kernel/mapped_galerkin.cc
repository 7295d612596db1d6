// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "mapped_run.h"

namespace contrecoup::gas
{
namespace
{
  Lines galerkin(const unsigned int degree,
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
      expect_rest<2>(lines + galerkin(degree));
    for (const Lines &lines : ball_and_shell<3>())
      expect_rest<3>(lines + galerkin(degree));
  }
}

TEST(MappedGalerkin, UniformFlowStays)
{
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    for (const Lines &lines : ball_and_shell<2>())
      expect_wind<2>(lines + galerkin(degree));
    for (const Lines &lines : ball_and_shell<3>())
      expect_wind<3>(lines + galerkin(degree));
  }
}

// A blob of denser gas drifts with the wind: leaves are troubled and blended,
// velocity and pressure stay uniform.
TEST(MappedGalerkin, BlendingKeepsVelocityAndPressure)
{
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    const auto totals =
      run<3>(ball_and_shell<3>()[0] + galerkin(degree) + mist, 5).second;
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
    expect_conservation<2>(ball_and_shell<2>()[0] + galerkin(degree));
    expect_conservation<3>(ball_and_shell<3>()[0] + galerkin(degree));
  }
}

TEST(MappedGalerkin, ProductsInAirAreKept)
{
  const auto [before, after] =
    run<3>(ball_and_shell<3>()[0] + galerkin(2) + charge, 20);
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
    const Lines method = galerkin(degree, "false") + mild;
    const Totals a = run<3>(mapped + method, 15).second;
    const Totals b = run<3>(box + method, 15).second;
    for (const auto &[name, value] : b)
      EXPECT_NEAR(a.at(name), value, 1e-11 * (1. + std::abs(value))) << name;
  }
}
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// Hanging faces between distorted leaves in the Galerkin scheme, on one rank;
// see mapped_galerkin.cc for several.

#include "../gas_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
/// Refined twice, a ball of three dimensions would have inverted leaves inside
/// with the sphere's manifold there.
template <int dim>
std::vector<std::string> ball(const unsigned int degree)
{
  return galerkin(degree) +
         std::vector<std::string>{"Domain/Dimension=" + std::to_string(dim),
                                  "Domain/Mesh=generator",
                                  "Domain/Generator=hyper_ball",
                                  std::string("Domain/Generator arguments=") +
                                    (dim == 2 ? "0,0:1:true" : "0,0,0:1:false"),
                                  "Domain/Initial refinement=1"};
}

/// Four distorted leaves with plane faces.
std::vector<std::string> simplex(const unsigned int degree)
{
  return galerkin(degree) +
         std::vector<std::string>{"Domain/Dimension=3",
                                  "Domain/Mesh=generator",
                                  "Domain/Generator=simplex",
                                  "Domain/Generator arguments="
                                  "0,0,0;1,0,0;0,1,0;0.2,0.1,1",
                                  "Domain/Initial refinement=1"};
}

/// One side is finer, at the outer and the inner coarse leaves.
template <int dim>
std::unique_ptr<GasRun<dim>> refined(const std::vector<std::string> &lines,
                                     const double right_of = 0.1)
{
  auto run = std::make_unique<GasRun<dim>>(lines);
  run->refine(
    [&](const Point<dim> &p) { return p[0] + 0.3 * p[1] > right_of; });
  EXPECT_GT(run->mesh.hanging_faces().size(), 0u);
  return run;
}

template <int dim>
void check_rest(const unsigned int degree)
{
  const auto run = refined<dim>(ball<dim>(degree));
  GasState<dim> state;
  state.density = 1.2;
  state.pressure = 101325.7;
  run->set_state([&](const Point<dim> &) { return state; });
  const auto before = run->leaves();
  run->steps(3);
  EXPECT_EQ(before, run->leaves()) << degree;
}

template <int dim>
void check_wind(const std::vector<std::string> &mesh,
                const double right_of,
                const unsigned int degree)
{
  const auto run =
    refined<dim>(mesh + std::vector<std::string>{"Initial state/Kind=uniform",
                                                 "Initial state/Background/"
                                                 "Density=1.4",
                                                 "Initial state/Background/"
                                                 "Velocity=0.3,-0.5",
                                                 "Initial state/Background/"
                                                 "Pressure=1",
                                                 "Boundaries/By id=0: initial"},
                 right_of);
  run->set_state(
    [&](const Point<dim> &p) { return run->initial_state.value(p); });
  run->steps(5);
  const auto after = run->totals();
  EXPECT_NEAR(after.at("smallest_density"), 1.4, 1e-12) << degree;
  EXPECT_NEAR(after.at("largest_density"), 1.4, 1e-12) << degree;
  EXPECT_NEAR(after.at("smallest_pressure"), 1., 1e-12) << degree;
  EXPECT_NEAR(after.at("largest_pressure"), 1., 1e-12) << degree;
}

template <int dim>
void check_blast(const unsigned int degree)
{
  const auto run = refined<dim>(ball<dim>(degree));
  run->set_state([](const Point<dim> &p) {
    GasState<dim> state;
    const bool inside = p.norm() < 0.4;
    state.density = inside ? 2. : 1.;
    state.pressure = inside ? 30. : 1.;
    return state;
  });
  const auto before = run->totals();
  run->steps(15);
  const auto after = run->totals();
  for (const std::string name : {"mass", "energy"})
    EXPECT_NEAR(after.at(name) / before.at(name), 1., 1e-13) << degree << name;
  EXPECT_GT(after.at("kinetic_energy"), 0.01);
  EXPECT_GT(after.at("smallest_pressure"), 0.);
}
} // namespace


TEST(GalerkinHanging, RestStaysToTheLastBit)
{
  for (const unsigned int degree : {1U, 2U, 3U, 5U})
    check_rest<2>(degree);
  for (const unsigned int degree : {1U, 3U})
    check_rest<3>(degree);
}


TEST(GalerkinHanging, UniformFlowStays)
{
  for (const unsigned int degree : {1U, 2U, 3U, 5U})
    check_wind<2>(ball<2>(degree), 0.1, degree);
  for (const unsigned int degree : {1U, 3U})
  {
    check_wind<3>(simplex(degree), 0.4, degree);
    check_wind<3>(ball<3>(degree), 0.1, degree);
  }
}


TEST(GalerkinHanging, ClosedBallKeepsMassAndEnergy)
{
  for (const unsigned int degree : {1U, 2U, 3U})
    check_blast<2>(degree);
  for (const unsigned int degree : {1U, 2U, 3U})
    check_blast<3>(degree);
}

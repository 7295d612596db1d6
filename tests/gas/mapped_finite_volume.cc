// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameter_tree.h>
#include <contrecoup/gas/gas_simulation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace contrecoup::gas
{
namespace
{
  using Lines = std::vector<std::string>;
  using Totals = std::map<std::string, double>;

  Lines operator+(Lines a, const Lines &b)
  {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  /// A mesh from one of deal.II's generators.
  Lines mesh(const int dim,
             const std::string &generator,
             const std::string &arguments,
             const unsigned int refinement)
  {
    return {"Domain/Dimension=" + std::to_string(dim),
            "Domain/Mesh=generator",
            "Domain/Generator=" + generator,
            "Domain/Generator arguments=" + arguments,
            "Domain/Initial refinement=" + std::to_string(refinement),
            "Method/Subcells=4"};
  }

  /// Totals before and after a number of steps.
  template <int dim>
  std::pair<Totals, Totals> run(const Lines &lines, const unsigned int n_steps)
  {
    dealii::ParameterHandler prm;
    GasSimulation<dim>::declare_parameters(prm);
    prm.enter_subsection("Time");
    prm.declare_entry("End time", "1");
    prm.leave_subsection();
    std::vector<Assignment> assignments;
    for (const std::string &line : lines)
      assignments.push_back(parse_override(line));
    apply_assignments(assignments, prm);

    GasSimulation<dim> simulation(MPI_COMM_WORLD);
    simulation.parse_parameters(prm);
    simulation.setup();
    std::pair<Totals, Totals> result;
    for (const auto &item : simulation.history())
      result.first[item.name] = item.value;
    for (unsigned int step = 0; step < n_steps; ++step)
      simulation.advance(1e10);
    for (const auto &item : simulation.history())
      result.second[item.name] = item.value;
    return result;
  }

  const Lines rest = {"Initial state/Kind=uniform"};

  const Lines wind = {"Initial state/Kind=uniform",
                      "Initial state/Background/Density=1.4",
                      "Initial state/Background/Velocity=0.3,-0.5",
                      "Initial state/Background/Pressure=1",
                      "Boundaries/By id=0: initial"};

  const Lines explosion = {"Initial state/Kind=regions",
                           "Initial state/Background/Density=1",
                           "Initial state/Background/Pressure=1",
                           "Initial state/Region charge/Radius=0.4",
                           "Initial state/Region charge/Center=0.2,0.1",
                           "Initial state/Region charge/Density=2",
                           "Initial state/Region charge/Pressure=30"};

  template <int dim>
  void expect_rest(const Lines &lines)
  {
    const auto [before, after] = run<dim>(lines + rest, 5);
    EXPECT_EQ(before, after);
    EXPECT_EQ(after.at("kinetic_energy"), 0.);
  }

  template <int dim>
  void expect_wind(const Lines &lines)
  {
    const auto totals = run<dim>(lines + wind, 5);
    const Totals &after = totals.second;
    EXPECT_NEAR(after.at("smallest_density"), 1.4, 1e-12);
    EXPECT_NEAR(after.at("largest_density"), 1.4, 1e-12);
    EXPECT_NEAR(after.at("smallest_pressure"), 1., 1e-12);
    EXPECT_NEAR(after.at("largest_pressure"), 1., 1e-12);
    const double square = 0.3 * 0.3 + 0.5 * 0.5;
    EXPECT_NEAR(
      after.at("kinetic_energy") / after.at("mass"), 0.5 * square, 1e-12);
  }

  template <int dim>
  void expect_conservation(const Lines &lines)
  {
    const auto [before, after] = run<dim>(lines + explosion, 20);
    EXPECT_NEAR(after.at("mass") / before.at("mass"), 1., 1e-13);
    EXPECT_NEAR(after.at("energy") / before.at("energy"), 1., 1e-13);
    EXPECT_GT(after.at("kinetic_energy"), 0.01);
    EXPECT_GT(after.at("smallest_pressure"), 0.);
  }
} // namespace

TEST(MappedFiniteVolume, RestStaysToTheLastBit)
{
  expect_rest<2>(mesh(2, "hyper_ball", "0,0:1:true", 2));
  expect_rest<2>(mesh(2, "hyper_shell", "0,0:1:2:7:false", 1));
  expect_rest<3>(mesh(3, "hyper_ball", "0,0,0:1:true", 1));
  expect_rest<3>(mesh(3, "hyper_shell", "0,0,0:1:2:6:false", 1));
}

TEST(MappedFiniteVolume, UniformFlowStays)
{
  expect_wind<2>(mesh(2, "hyper_ball", "0,0:1:true", 2));
  expect_wind<2>(mesh(2, "hyper_shell", "0,0:1:2:7:false", 1));
  expect_wind<3>(mesh(3, "hyper_ball", "0,0,0:1:true", 1));
  expect_wind<3>(mesh(3, "hyper_shell", "0,0,0:1:2:6:false", 1));
}

TEST(MappedFiniteVolume, ClosedBallKeepsMassAndEnergy)
{
  expect_conservation<2>(mesh(2, "hyper_ball", "0,0:1:true", 2));
  expect_conservation<3>(mesh(3, "hyper_ball", "0,0,0:1:true", 1));
}

TEST(MappedFiniteVolume, ProductsInAirAreKept)
{
  const Lines charge = {"Material/Equation of state=jwl in air",
                        "Material/Explosive=tnt",
                        "Initial state/Kind=regions",
                        "Initial state/Region charge/Radius=0.4",
                        "Initial state/Region charge/Center=0.2,0.1",
                        "Initial state/Region charge/Burned explosive=true"};
  for (const std::string limiter : {"none", "venkatakrishnan"})
  {
    const auto [before, after] =
      run<3>(mesh(3, "hyper_ball", "0,0,0:1:true", 1) + charge +
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
    const Lines limiter = {"Method/Gradient limiter=" + name};
    expect_conservation<2>(mesh(2, "hyper_ball", "0,0:1:true", 2) + limiter);
    expect_conservation<3>(mesh(3, "hyper_ball", "0,0,0:1:true", 1) + limiter);
    expect_wind<3>(mesh(3, "hyper_ball", "0,0,0:1:true", 1) + limiter);
  }
}

// The same box, once by the kernel for boxes.
TEST(MappedFiniteVolume, AgreesWithTheKernelForBoxes)
{
  const Lines mapped =
    mesh(3, "subdivided_hyper_rectangle", "2,1,1:-1,-1,-1:3,1,1:true", 1);
  const Lines box = {"Domain/Dimension=3",
                     "Domain/Lower corner=-1,-1,-1",
                     "Domain/Upper corner=3,1,1",
                     "Domain/Coarse leaves=2,1,1",
                     "Domain/Initial refinement=1",
                     "Method/Subcells=4",
                     "Boundaries/x low=open"};
  const Lines open = {"Boundaries/By id=0: open"};
  const Totals a = run<3>(mapped + open + explosion, 15).second;
  const Totals b = run<3>(box + explosion, 15).second;
  for (const auto &[name, value] : b)
    EXPECT_NEAR(a.at(name), value, 1e-11 * (1. + std::abs(value))) << name;
}

TEST(MappedFiniteVolume, OtherSchemesAreRefused)
{
  const Lines lines = mesh(2, "hyper_ball", "0,0:1:true", 1) + rest;
  for (const std::string line : {"Method/Scheme=discontinuous galerkin",
                                 "Adaptation/Active=true",
                                 "Pictures/Planes=all"})
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

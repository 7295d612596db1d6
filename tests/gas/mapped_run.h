// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/run/gas_simulation.h>

#include "../set_entries.h"
#include "run_lines.h"
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace contrecoup::gas
{
using Lines = std::vector<std::string>;
using Totals = std::map<std::string, double>;

/// A mesh from one of deal.II's generators.
inline Lines mesh(const int dim,
                  const std::string &generator,
                  const std::string &arguments,
                  const unsigned int refinement)
{
  return {"Domain/Dimension=" + std::to_string(dim),
          "Domain/Mesh=generator",
          "Domain/Generator=" + generator,
          "Domain/Generator arguments=" + arguments,
          "Domain/Initial refinement=" + std::to_string(refinement)};
}

/// The distorted cube of the shipped scenes, whose seven cells are numbered in
/// different directions.
inline Lines distorted_cube(const unsigned int refinement)
{
  return {"Domain/Dimension=3",
          "Domain/Mesh=file",
          "Domain/Mesh file=" CONTRECOUP_MESHES "/distorted_cube.msh",
          "Domain/Initial refinement=" + std::to_string(refinement)};
}

/// Finer leaves in a box.
inline Lines finer(const std::string &lower,
                   const std::string &upper,
                   const unsigned int levels)
{
  return {"Adaptation/Fine box lower corner=" + lower,
          "Adaptation/Fine box upper corner=" + upper,
          "Adaptation/Fine box levels=" + std::to_string(levels)};
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
  set_entries(prm, lines);

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

inline const Lines rest = {"Initial state/Kind=uniform"};

inline const Lines wind = {"Initial state/Kind=uniform",
                           "Initial state/Background/Density=1.4",
                           "Initial state/Background/Velocity=0.3,-0.5",
                           "Initial state/Background/Pressure=1",
                           "Boundaries/By id=0: initial"};

inline const Lines explosion = {"Initial state/Kind=regions",
                                "Initial state/Background/Density=1",
                                "Initial state/Background/Pressure=1",
                                "Initial state/Region charge/Radius=0.4",
                                "Initial state/Region charge/Center=0.2,0.1",
                                "Initial state/Region charge/Density=2",
                                "Initial state/Region charge/Pressure=30"};

inline const Lines charge = {
  "Material/Equation of state=jwl in air",
  "Material/Explosive=tnt",
  "Initial state/Kind=regions",
  "Initial state/Region charge/Radius=0.4",
  "Initial state/Region charge/Center=0.2,0.1",
  "Initial state/Region charge/Burned explosive=true"};

template <int dim>
void expect_rest(const Lines &lines)
{
  const auto [before, after] = run<dim>(lines + rest, 5);
  EXPECT_EQ(before, after);
  EXPECT_EQ(after.at("kinetic_energy"), 0.);
}

template <int dim>
void expect_wind(const Lines &lines, const double tolerance = 1e-12)
{
  const auto totals = run<dim>(lines + wind, 5);
  const Totals &after = totals.second;
  EXPECT_NEAR(after.at("smallest_density"), 1.4, tolerance);
  EXPECT_NEAR(after.at("largest_density"), 1.4, tolerance);
  EXPECT_NEAR(after.at("smallest_pressure"), 1., tolerance);
  EXPECT_NEAR(after.at("largest_pressure"), 1., tolerance);
  const double square = 0.3 * 0.3 + 0.5 * 0.5;
  EXPECT_NEAR(
    after.at("kinetic_energy") / after.at("mass"), 0.5 * square, tolerance);
}

template <int dim>
void expect_conservation(const Lines &lines,
                         const double tolerance = 1e-13,
                         const unsigned int n_steps = 20)
{
  const auto [before, after] = run<dim>(lines + explosion, n_steps);
  EXPECT_NEAR(after.at("mass") / before.at("mass"), 1., tolerance);
  EXPECT_NEAR(after.at("energy") / before.at("energy"), 1., tolerance);
  EXPECT_GT(after.at("kinetic_energy"), 0.01);
  EXPECT_GT(after.at("smallest_pressure"), 0.);
}

/// Meshes of distorted cells whose faces meet in different orientations.
template <int dim>
std::vector<Lines> ball_and_shell()
{
  if constexpr (dim == 2)
    return {mesh(2, "hyper_ball", "0,0:1:true", 2),
            mesh(2, "hyper_shell", "0,0:1:2:7:false", 1)};
  else
    return {mesh(3, "hyper_ball", "0,0,0:1:false", 1),
            mesh(3, "hyper_shell", "0,0,0:1:2:6:false", 1)};
}
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// Throughput of the gas solver on a periodic cube, one row per case, and of a
// plain loop. Started without arguments it runs itself under mpirun,
// on one rank and on two; "benchmark_gas scene" gives the row of scenes alone,
// "benchmark_gas finite_volumes" and "benchmark_gas galerkin" those of a
// scheme.

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/gas/run/gas_simulation.h>

#include <deal.II/base/mpi.h>

#include "control_loop.h"
#include "on_ranks.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <set>
#include <stdexcept>

namespace
{
using namespace contrecoup;
using Settings = std::map<std::string, std::string>;

const Settings galerkin_3 = {{"Method/Scheme", "discontinuous galerkin"},
                             {"Method/Degree", "3"},
                             {"Method/Time stepping", "ssp rk3"},
                             {"Domain/Coarse leaves", "32, 32, 32"}};
const Settings galerkin_2 = {{"Method/Scheme", "discontinuous galerkin"},
                             {"Method/Degree", "2"},
                             {"Method/Time stepping", "ssp rk3"},
                             {"Domain/Coarse leaves", "40, 40, 40"}};
const Settings finite_volume = {{"Method/Scheme", "finite volume"},
                                {"Method/Subcells", "8"},
                                {"Domain/Coarse leaves", "16, 16, 16"}};
const Settings single = {{"Method/Precision", "single"}};
const Settings jwl = {{"Material/Equation of state", "jwl in air"}};
const Settings slab = {{"Initial state/Expression/Pressure",
                        "1e5 * (1 + 4 * (abs(x + 0.3*y - 0.65) < 0.1))"}};

/// A run like those of scenes: products of an explosive expand into air near a
/// body with cells of a quarter of the size at its skin. Wind keeps all leaves
/// active.
const Settings scene = {{"Domain/Periodic directions", ""},
                        {"Domain/Coarse leaves", "16, 16, 16"},
                        {"Material/Equation of state", "jwl in air"},
                        {"Method/Subcells", "4"},
                        {"Method/Precision", "single"},
                        {"Adaptation/Active", "true"},
                        {"Adaptation/Largest level", "2"},
                        {"Rigid body/Kind", "body"},
                        {"Rigid body/Levels", "2"},
                        {"Body/Kind", "shape"},
                        {"Body/Shape/Size", "0.2"},
                        {"Body/Shift", "0.7, 0.5, 0.5"},
                        {"Initial state/Kind", "layers"},
                        {"Initial state/Layers/Positions", "0.3"},
                        {"Initial state/Layers/Densities", "10, 1.2"},
                        {"Initial state/Layers/Velocities", "30, 30"},
                        {"Initial state/Layers/Pressures", "1e7, 1e5"},
                        {"Initial state/Layers/Products", "1, 0"}};

Settings operator+(Settings a, const Settings &b)
{
  for (const auto &[entry, value] : b)
    a[entry] = value;
  return a;
}

void set(ParameterHandler &prm, const Settings &settings)
{
  for (const auto &[entry, value] : settings)
  {
    auto path = dealii::Utilities::split_string_list(entry, '/');
    const std::string name = path.back();
    path.pop_back();
    for (const auto &section : path)
      prm.enter_subsection(section);
    prm.set(name, value);
    for (std::size_t i = 0; i < path.size(); ++i)
      prm.leave_subsection();
  }
}

/// Results of a case.
struct Throughput
{
  double unknowns_per_second = 0.; ///< updates per stage and core
  double troubled = 0.;            ///< share of troubled leaves [-]
  double components = 5.;
};

/// Parses the settings, on top of a smooth flow in a periodic cube, and
/// builds the initial state.
void set_up(gas::GasSimulation<3> &simulation, const Settings &settings)
{
  ParameterHandler prm;
  gas::GasSimulation<3>::declare_parameters(prm);
  {
    const Section section(prm, "Time");
    declare_double(prm, "End time", "1", 0., 1., "s", "Unused.");
  }
  const Settings flow = {
    {"Domain/Periodic directions", "x, y, z"},
    {"Initial state/Kind", "expression"},
    {"Initial state/Expression/Density", "1 + 0.1 * sin(2*pi*x)*cos(2*pi*y)"},
    {"Initial state/Expression/Velocity x", "30"},
    {"Initial state/Expression/Velocity y", "20"},
    {"Initial state/Expression/Pressure", "1e5"}};
  set(prm, flow + settings);
  simulation.parse_parameters(prm);
  simulation.setup();
}

/// The largest of three rates per second of processor time, which other
/// programs on the machine change less than that of the clock.
/// @param work does something and returns how much
template <typename Work>
double best_rate(const Work &work)
{
  double best = 0.;
  for (unsigned int repetition = 0; repetition < 3; ++repetition)
  {
    const std::clock_t start = std::clock();
    const double done = work();
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    best = std::max(best, done / seconds);
  }
  return best;
}

/// @param n_first steps before the clock starts
Throughput measure(const Settings &settings,
                   const MPI_Comm communicator = MPI_COMM_WORLD,
                   const unsigned int n_first = 1)
{
  gas::GasSimulation<3> simulation(communicator);
  set_up(simulation, settings);
  for (unsigned int step = 0; step < n_first; ++step)
    simulation.advance(1.);

  Throughput best;
  const auto take_steps = [&]() {
    double updates = 0.;
    for (unsigned int step = 0; step < 3; ++step)
      updates += simulation.advance(1.).updates;
    return updates / dealii::Utilities::MPI::n_mpi_processes(communicator);
  };
  best.unknowns_per_second = best_rate(take_steps);
  for (const auto &value : simulation.checks())
    if (value.name == "troubled_leaves")
      best.troubled = value.value;
  best.components = settings.count("Material/Equation of state") ? 6. : 5.;
  return best;
}

/// Cell-updates per second of an explosion on a mesh that follows it, with
/// adaptation, totals and probes in every step.
double measure_adaptive()
{
  const Settings explosion = {
    {"Domain/Periodic directions", ""},
    {"Domain/Coarse leaves", "2, 2, 2"},
    {"Domain/Initial refinement", "1"},
    {"Adaptation/Active", "true"},
    {"Adaptation/Largest level", "4"},
    {"Probes/Points", "0.7, 0.5, 0.5; 0.5, 0.9, 0.5"},
    {"Initial state/Expression/Density", "1"},
    {"Initial state/Expression/Velocity x", "0"},
    {"Initial state/Expression/Velocity y", "0"},
    {"Initial state/Expression/Pressure",
     "1e5 + 1e7 * ((x-0.5)^2 + (y-0.5)^2 + (z-0.5)^2 < 0.01)"}};
  gas::GasSimulation<3> simulation(MPI_COMM_WORLD);
  set_up(simulation, finite_volume + explosion);
  simulation.advance(1.);
  const std::clock_t start = std::clock();
  double updates = 0.;
  for (unsigned int step = 0; step < 100; ++step)
  {
    updates += simulation.advance(1.).updates;
    simulation.adapt();
    simulation.history();
    simulation.probes();
  }
  return updates / 5. * CLOCKS_PER_SEC / double(std::clock() - start);
}

void print(const char *name, const double value, const char *unit)
{
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
  {
    std::printf("%s,%.6g,%s\n", name, value, unit);
    std::fflush(stdout);
  }
}

/// Cell-updates per second of the plain loop.
double measure_control()
{
  // No power of two: lines across memory would fall on one part of the cache.
  ControlLoop loop(100);
  loop.stage();
  const double energy = loop.mean_energy();
  const double rate = best_rate([&]() {
    loop.stage();
    loop.stage();
    return 2. * loop.n_cells();
  });
  if (!(std::abs(loop.mean_energy() - energy) < 1e-12 * energy))
    throw std::runtime_error("the control loop does not conserve energy");
  return rate;
}

const char *const unknowns = "unknown-updates/(s core) per stage";
const char *const cells = "cell-updates/(s core) per stage";

/// Rows of the discontinuous Galerkin scheme.
void measure_galerkin()
{
  const double dg3 = measure(galerkin_3).unknowns_per_second;
  const double dg3_single = measure(galerkin_3 + single).unknowns_per_second;
  print("gas_dg3_clean", dg3, unknowns);
  print("gas_dg3_single", dg3_single, unknowns);
  const Throughput troubled = measure(galerkin_3 + slab);
  print("gas_dg3_troubled", troubled.unknowns_per_second, unknowns);
  print("gas_dg3_troubled_share", troubled.troubled, "-");
  print("gas_dg2_clean", measure(galerkin_2).unknowns_per_second, unknowns);
}

/// Rows of the finite-volume scheme.
/// @param control speed of the plain loop
void measure_finite_volumes(const double control)
{
  const Throughput ideal = measure(finite_volume);
  const double single_cells =
    measure(finite_volume + single).unknowns_per_second / ideal.components;
  const Throughput mixture = measure(finite_volume + jwl);
  const double ideal_cells = ideal.unknowns_per_second / ideal.components;
  const double jwl_cells = mixture.unknowns_per_second / mixture.components;
  print("gas_fv2", ideal_cells, cells);
  print("gas_fv2_single", single_cells, cells);
  print("gas_single_over_double", single_cells / ideal_cells, "speed ratio");
  print("gas_fv2_adaptive", measure_adaptive(), cells);
  print("gas_jwl_over_ideal", ideal_cells / jwl_cells, "time ratio");
  print("gas_fv2_over_control", ideal_cells / control, "speed ratio");
  print("gas_fv2_single_over_control", single_cells / control, "speed ratio");
}

/// Rows of what scenes run, and of the plain loop, whose speed is returned.
double measure_scene()
{
  const double scene_cells =
    measure(scene, MPI_COMM_WORLD, 20).unknowns_per_second / 6.;
  const double control = measure_control();
  print("gas_scene", scene_cells, cells);
  print("gas_control", control, cells);
  print("gas_scene_over_control", scene_cells / control, "speed ratio");
  return control;
}

void measure_one_rank(const std::string &rows)
{
  if (rows == "all" || rows == "galerkin")
    measure_galerkin();
  if (rows == "galerkin")
    return;
  const double control = measure_scene();
  if (rows != "scene")
    measure_finite_volumes(control);
}

/// How much faster two ranks are than one of them alone.
void measure_two_ranks()
{
  double alone = 0.;
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    alone = measure(finite_volume, MPI_COMM_SELF).unknowns_per_second;
  MPI_Barrier(MPI_COMM_WORLD);
  const double each = measure(finite_volume).unknowns_per_second;
  print("gas_two_ranks", 2. * each / alone, "speed ratio");
}
} // namespace


int main(int argc, char **argv)
{
  const std::string word = argc == 2 ? argv[1] : "";
  const std::set<std::string> kinds = {"scene", "finite_volumes", "galerkin"};
  const std::string rows = kinds.count(word) ? word : "all";
  return contrecoup::measure_on_ranks(
    argc, argv, [&]() { measure_one_rank(rows); }, measure_two_ranks);
}

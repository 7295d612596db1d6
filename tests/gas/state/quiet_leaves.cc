// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "gas_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
using Lines = std::vector<std::string>;

/// A burst in a corner of gas at rest; the hot ball may hold products.
template <int dim>
GasState<dim> burst(const Point<dim> &place)
{
  GasState<dim> state;
  state.density = 1.225;
  state.pressure = 101325.;
  if (place.norm() < 0.2)
  {
    state.density = 30.;
    state.pressure = 1e8;
    state.products = 1.;
  }
  return state;
}


/// Runs a burst with or without skipping; @p hanging: with some leaves
/// halved where the gas is at rest.
template <int dim>
std::unique_ptr<GasRun<dim>> run_burst(const Lines &lines,
                                       const bool skip,
                                       const bool hanging,
                                       const bool adapting)
{
  auto run = std::make_unique<GasRun<dim>>(
    lines +
    Lines{std::string("Method/Skip quiet leaves=") + (skip ? "true" : "false"),
          "Domain/Initial refinement=" + std::to_string(dim == 3 ? 2 : 3)});
  if (hanging)
    run->refine([](const Point<dim> &p) { return p[0] > 0.6 || p[1] < 0.2; });
  run->set_state(burst<dim>, true);
  for (unsigned int i = 0; i < 8; ++i)
  {
    EXPECT_FALSE(run->step().failed);
    if (adapting && i % 2 == 1)
      run->adapt();
  }
  return run;
}


/// The leaves of all ranks.
template <int dim>
std::map<std::string, std::vector<double>> all_leaves(const GasRun<dim> &run)
{
  std::map<std::string, std::vector<double>> all;
  for (const auto &leaves :
       dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, run.leaves()))
    all.insert(leaves.begin(), leaves.end());
  return all;
}


/// Skipping changes no bit, and skips.
template <int dim>
void check(const Lines &lines,
           const bool hanging = dim > 1,
           const bool adapting = false)
{
  const auto plain = run_burst<dim>(lines, false, hanging, adapting);
  const auto skipping = run_burst<dim>(lines, true, hanging, adapting);
  EXPECT_EQ(plain->time, skipping->time);
  EXPECT_EQ(all_leaves(*plain), all_leaves(*skipping));
  // Several ranks share the leaves of an adapted mesh by what they cost.
  const bool same_leaves =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1 || !adapting;
  for (unsigned int leaf = 0; same_leaves && leaf < plain->mesh.n_owned();
       ++leaf)
  {
    EXPECT_EQ(plain->field.sensor_of(leaf), skipping->field.sensor_of(leaf));
    EXPECT_EQ(plain->stepper->signal_rate(leaf),
              skipping->stepper->signal_rate(leaf));
  }
  const auto &quiet = *skipping->quiet_leaves;
  const double computed =
    dealii::Utilities::MPI::sum(quiet.n_computed(), MPI_COMM_WORLD);
  const double possible =
    dealii::Utilities::MPI::sum(quiet.n_possible(), MPI_COMM_WORLD);
  EXPECT_LT(computed, 0.95 * possible);
  EXPECT_GT(computed, 0.);
  EXPECT_EQ(plain->quiet_leaves->n_computed(),
            plain->quiet_leaves->n_possible());
}


const Lines open = {"Boundaries/x high=open", "Boundaries/y high=open"};
const Lines adaptive = {"Adaptation/Active=true",
                        "Adaptation/Smallest level=2",
                        "Adaptation/Largest level=4"};
} // namespace


TEST(QuietLeaves, FiniteVolumes)
{
  for (const std::string geometry : {"plane", "cylindrical", "spherical"})
    check<1>(finite_volume(8) + Lines{"Domain/Geometry=" + geometry,
                                      "Domain/Coarse leaves=5",
                                      "Boundaries/x high=open"});
  for (const unsigned int n : {1U, 2U, 8U})
  {
    check<2>(finite_volume(n) + open);
    check<2>(finite_volume(n) + Lines{"Domain/Geometry=axisymmetric"});
  }
  check<2>(finite_volume(4) + products_in_air());
  check<3>(finite_volume(4) + open);
}


TEST(QuietLeaves, Galerkin)
{
  for (const unsigned int degree : {1U, 2U, 3U})
    check<2>(galerkin(degree) + open);
  check<2>(galerkin(3) + products_in_air());
  check<3>(galerkin(2));
}


TEST(QuietLeaves, AdaptiveMeshes)
{
  check<2>(finite_volume(8) + adaptive + open, false, true);
  check<2>(finite_volume(4) + adaptive + Lines{"Domain/Geometry=axisymmetric"},
           false,
           true);
  check<2>(galerkin(3) + adaptive, false, true);
  check<3>(finite_volume(4) + adaptive + products_in_air(), false, true);
}


TEST(QuietLeaves, SinglePrecision)
{
  const Lines single = {"Method/Precision=single"};
  check<3>(finite_volume(4) + single + products_in_air());
  check<3>(galerkin(2) + single);
}


TEST(QuietLeaves, MappedMeshes)
{
  const Lines ball = {"Domain/Mesh=generator",
                      "Domain/Generator=hyper_ball",
                      "Domain/Generator arguments=0, 0 : 1 : true"};
  check<2>(finite_volume(4) + ball, false);
  check<2>(galerkin(2) + ball, false);
}


TEST(QuietLeaves, ABoundaryWithAStateOfItsOwnSendsItsWave)
{
  const auto run = [](const bool skip) {
    auto result = std::make_unique<GasRun<2>>(
      finite_volume(4) + Lines{std::string("Method/Skip quiet leaves=") +
                                 (skip ? "true" : "false"),
                               "Domain/Initial refinement=3",
                               "Boundaries/x low=inflow",
                               "Boundaries/Inflow/Density=3",
                               "Boundaries/Inflow/Pressure=4e5",
                               "Boundaries/Inflow/Velocity=300, 0, 0"});
    result->set_state([](const Point<2> &) {
      GasState<2> state;
      state.density = 1.225;
      state.pressure = 101325.;
      return state;
    });
    result->steps(20);
    return result;
  };
  const auto plain = run(false);
  const auto skipping = run(true);
  EXPECT_EQ(plain->leaves(), skipping->leaves());
  EXPECT_LT(skipping->quiet_leaves->n_computed(),
            0.8 * skipping->quiet_leaves->n_possible());
  double fastest = 0.;
  for (const auto &[name, values] : skipping->leaves())
    fastest = std::max(fastest, values[16]);
  fastest = dealii::Utilities::MPI::max(fastest, MPI_COMM_WORLD);
  EXPECT_GT(fastest, 500.);
}


TEST(QuietLeaves, RegriddingKeepsTheAmbientState)
{
  // Halved and merged again, gas at rest keeps its bits: leaves stay quiet.
  for (const Lines &method : {finite_volume(8), galerkin(3)})
  {
    GasRun<2> run(method + Lines{"Domain/Initial refinement=2",
                                 "Adaptation/Active=true",
                                 "Adaptation/Smallest level=1",
                                 "Adaptation/Largest level=3"});
    run.set_state([](const Point<2> &) {
      GasState<2> state;
      state.density = 1.225;
      state.pressure = 101325.;
      return state;
    });
    const double before = run.mesh.n_global();
    EXPECT_TRUE(run.adapt());
    EXPECT_LT(run.mesh.n_global(), before);
    run.steps(2);
    EXPECT_EQ(run.quiet_leaves->n_computed(), 0.);
  }
}


TEST(QuietLeaves, ADetonationRunsThroughQuietExplosive)
{
  // Most of the domain is explosive: uniform and at rest, but not quiet.
  const auto run = [](const bool skip) {
    GasRun<1> result(finite_volume(8) + products_in_air() +
                     Lines{std::string("Method/Skip quiet leaves=") +
                             (skip ? "true" : "false"),
                           "Domain/Coarse leaves=20",
                           "Charges/Charge slab/Shape=box",
                           "Charges/Charge slab/Center=0.4",
                           "Charges/Charge slab/Edges=0.8",
                           "Charges/Charge slab/Ignition points=0"});
    result.set_charges();
    result.steps(60);
    EXPECT_GT(result.totals()["largest_pressure"], 1e10);
    return result.leaves();
  };
  EXPECT_EQ(run(false), run(true));
}

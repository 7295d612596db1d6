// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "gas_run.h"
#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
/// A small ball of high pressure in thin cold air.
template <int dim>
GasState<dim> strong_blast(const Point<dim> &p)
{
  Point<dim> centre;
  for (unsigned int d = 0; d < dim; ++d)
    centre[d] = 0.5;
  const bool inside = p.distance(centre) < 0.2;
  GasState<dim> state;
  state.density = inside ? 1. : 1e-3;
  state.pressure = inside ? 1e10 : 1e-2;
  return state;
}


/// A detonated charge of TNT in air.
template <int dim>
GasState<dim> charge(const Point<dim> &p)
{
  Point<dim> centre;
  for (unsigned int d = 0; d < dim; ++d)
    centre[d] = 0.5;
  const bool inside = p.distance(centre) < 0.2;
  GasState<dim> state;
  state.density = inside ? 1630. : 1.225;
  state.pressure = inside ? 8e9 : 1e5;
  state.products = inside ? 1. : 0.;
  return state;
}


/// Largest number of retries in @p n steps; density and pressure stay
/// finite and admissible.
template <int dim>
unsigned int check_blast(const std::vector<std::string> &lines,
                         const StateFunction<dim> &state,
                         const unsigned int n)
{
  GasRun<dim> run(lines +
                  std::vector<std::string>{"Domain/Initial refinement=2"});
  run.refine([](const Point<dim> &p) { return p[0] < 0.5; });
  run.set_state(state);
  const auto before = run.totals();
  unsigned int retries = 0;
  for (unsigned int i = 0; i < n; ++i)
  {
    const auto result = run.step();
    if (result.failed)
    {
      ADD_FAILURE() << "step " << i << " failed, " << lines.front() << ", "
                    << lines[1];
      return 100;
    }
    retries = std::max(retries, result.retries);
  }
  const auto after = run.totals();
  EXPECT_GT(after.at("smallest_density"), 0.);
  for (const std::string name : {"mass", "energy"})
    EXPECT_NEAR(after.at(name), before.at(name), 1e-12 * before.at(name));
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
  {
    const auto values = run.field.leaf(leaf);
    for (unsigned int q = 0; q < run.layout.n_points; ++q)
    {
      std::vector<double> u(run.layout.n_components);
      double kinetic = 0.;
      for (unsigned int c = 0; c < u.size(); ++c)
        u[c] = values[c * run.layout.n_points + q];
      for (unsigned int d = 0; d < dim; ++d)
        kinetic += 0.5 * u[1 + d] * u[1 + d] / u[0];
      const double products =
        run.material.has_products() ? u[dim + 2] / u[0] : 0.;
      EXPECT_GT(u[0], 0.);
      EXPECT_GT(u[dim + 1] - kinetic -
                  run.material.least_energy_density(u[0], products),
                0.);
      // The mass fraction is no part of the admissible set.
      EXPECT_GE(products, -1e-3);
      EXPECT_LE(products, 1. + 1e-3);
    }
  }
  return retries;
}


/// How far the mass fraction of products leaves [0, 1] in @p n steps.
template <int dim>
double largest_excess(const std::vector<std::string> &lines,
                      const unsigned int n)
{
  GasRun<dim> run(lines +
                  std::vector<std::string>{"Domain/Coarse leaves=4, 4, 4"});
  run.set_state(charge<dim>, true);
  double excess = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    run.steps(1);
    for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    {
      const auto values = run.field.leaf(leaf);
      const unsigned int n_points = run.layout.n_points;
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const double fraction = values[(dim + 2) * n_points + q] / values[q];
        excess = std::max({excess, -fraction, fraction - 1.});
      }
    }
  }
  return dealii::Utilities::MPI::max(excess, MPI_COMM_WORLD);
}


/// Independent states in all points: densities and thermal energies over
/// @p decades powers of ten, Mach numbers up to about @p mach.
template <int dim>
void set_rough_state(GasRun<dim> &run,
                     const unsigned int seed,
                     const double decades,
                     const double mach)
{
  run.field.reinit(run.layout, run.mesh.n_stored_batches());
  const unsigned int n_points = run.layout.n_points;
  std::vector<double> values(run.layout.n_components * n_points);
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
  {
    std::mt19937 engine(1000 * seed +
                        run.mesh.cell(leaf)->global_active_cell_index());
    std::uniform_real_distribution<double> any(-1., 1.);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      GasState<dim> state;
      state.density = std::pow(10., 0.5 * decades * any(engine));
      if (run.material.has_products())
        state.products = 0.5 + 0.5 * any(engine);
      const double thermal = 2.5e5 * std::pow(10., 0.5 * decades * any(engine));
      state.pressure = run.material.pressure(
        state.density,
        run.material.least_energy_density(state.density, state.products) +
          thermal,
        state.products);
      for (unsigned int d = 0; d < dim; ++d)
        state.velocity[d] =
          mach * std::sqrt(thermal / state.density) * any(engine);
      const auto u =
        conserved_state(state, run.material, run.layout.n_components);
      for (unsigned int c = 0; c < u.size(); ++c)
        values[c * n_points + q] = u[c];
    }
    run.field.set_leaf(leaf, values);
  }
  run.field.fill_padding(run.mesh.n_owned());
  run.stepper->reinit(run.field);
}


/// Rough gas on an irregular mesh takes 20 steps with few retries.
template <int dim>
void check_rough_gas(const std::vector<std::string> &method,
                     const unsigned int most_retries = 0)
{
  for (unsigned int seed = 1; seed <= 3; ++seed)
    for (const double decades : {1., 4.})
      for (const double mach : {0.3, 10.})
      {
        GasRun<dim> run(method +
                        std::vector<std::string>{"Domain/Initial refinement=1",
                                                 "Domain/Coarse leaves=2, 2, 1",
                                                 "Boundaries/x low=open"});
        run.refine([&](const Point<dim> &p) {
          return std::fmod(7.3 * p.norm() + 0.4 * seed, 1.) < 0.5;
        });
        set_rough_state(run, seed, decades, mach);
        unsigned int retries = 0;
        for (unsigned int i = 0; i < 20; ++i)
          retries += run.step().retries;
        EXPECT_LE(retries, most_retries)
          << method[0] << ", " << method[1] << ", seed " << seed << ", decades "
          << decades << ", Mach number " << mach;
      }
}


/// Gas that a shock runs into.
GasState<2> shocked(const Point<2> &p)
{
  GasState<2> state;
  state.density = 1.;
  state.pressure = p[0] < 0.4 ? 1e10 : 1e5;
  return state;
}
} // namespace


TEST(Positivity, FiniteVolumesInAStrongBlast)
{
  for (const std::string limiter : {"minmod", "van leer", "mc"})
  {
    const std::vector<std::string> lines = {"Method/Limiter=" + limiter};
    EXPECT_EQ(check_blast<2>(finite_volume(8) + lines, strong_blast<2>, 60),
              0u);
    EXPECT_LE(check_blast<2>(
                finite_volume(4) + lines + products_in_air(), charge<2>, 60),
              2u);
  }
  EXPECT_EQ(check_blast<3>(finite_volume(4), strong_blast<3>, 15), 0u);
}


TEST(Positivity, GalerkinInAStrongBlast)
{
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    EXPECT_LE(check_blast<2>(galerkin(degree), strong_blast<2>, 60), 2u);
    EXPECT_LE(
      check_blast<2>(galerkin(degree) + products_in_air(), charge<2>, 60), 2u);
  }
  EXPECT_LE(check_blast<3>(galerkin(2), strong_blast<3>, 15), 2u);
}


TEST(Positivity, FiniteVolumesInRoughGas)
{
  for (const unsigned int n : {1U, 2U, 8U})
    check_rough_gas<2>(finite_volume(n));
  check_rough_gas<2>(finite_volume(4) + products_in_air());
  check_rough_gas<3>(finite_volume(2));
}


TEST(Positivity, GalerkinInRoughGas)
{
  for (const unsigned int degree : {1U, 2U, 3U})
    check_rough_gas<2>(galerkin(degree), 4);
  check_rough_gas<2>(galerkin(3) + products_in_air(), 4);
  check_rough_gas<3>(galerkin(1), 4);
}


TEST(Retries, AStepTooLargeIsHalvedAndCounted)
{
  // Galerkin leaves only need a mean that is admissible, so they bear more.
  for (const bool is_galerkin : {false, true})
  {
    const auto method = is_galerkin ? galerkin(3) : finite_volume(8);
    const double factor = is_galerkin ? 100. : 20.;
    GasRun<2> run(method +
                  std::vector<std::string>{"Domain/Initial refinement=2"});
    run.set_state(shocked);
    const double stable = run.stepper->stable_step();
    const auto result = run.step(factor);
    EXPECT_FALSE(result.failed);
    EXPECT_FALSE(result.unphysical_leaf);
    EXPECT_GE(result.retries, 1u);
    EXPECT_LE(result.retries, 10u);
    EXPECT_DOUBLE_EQ(result.step,
                     factor * stable * std::pow(0.5, result.retries));
    EXPECT_GT(run.totals().at("smallest_density"), 0.);
    EXPECT_GT(run.totals().at("smallest_pressure"), 0.);

    // The step that was taken in the end is that of a run that tried it at
    // once.
    GasRun<2> direct(method +
                     std::vector<std::string>{"Domain/Initial refinement=2"});
    direct.set_state(shocked);
    EXPECT_EQ(direct.stepper->advance(direct.field, 0., result.step).retries,
              0u);
    EXPECT_EQ(run.leaves(), direct.leaves());
  }
}


TEST(Retries, AllFailingLeaveTheStateUntouched)
{
  for (const auto &method : {finite_volume(8), galerkin(3)})
  {
    GasRun<2> run(method +
                  std::vector<std::string>{"Domain/Initial refinement=2",
                                           "Method/Largest number of "
                                           "retries=2"});
    run.set_state(shocked);
    const auto before = run.leaves();
    const auto result =
      run.stepper->advance(run.field, 0., 1e4 * run.stepper->stable_step());
    EXPECT_TRUE(result.failed);
    EXPECT_EQ(result.retries, 2u);
    const bool has_leaf = result.unphysical_leaf.has_value();
    EXPECT_GT(dealii::Utilities::MPI::sum(has_leaf ? 1U : 0U, MPI_COMM_WORLD),
              0u);
    if (has_leaf)
    {
      EXPECT_LT(*result.unphysical_leaf, run.mesh.n_owned());
    }
    EXPECT_EQ(run.leaves(), before);
    // The run can continue from there.
    EXPECT_FALSE(run.step().failed);
  }
}


TEST(Retries, StableStepsScaleWithTheMesh)
{
  const auto stable_step = [](const std::string &refinement) {
    GasRun<2> run(
      finite_volume(4) +
      std::vector<std::string>{"Domain/Initial refinement=" + refinement,
                               "Method/CFL number=0.4"});
    run.set_state([](const Point<2> &) {
      GasState<2> state;
      state.density = 1.4;
      state.pressure = 1e4;
      state.velocity[0] = -50.;
      return state;
    });
    return run.stepper->stable_step();
  };
  // c = 100 m/s; sum of (|u| + c) / h over both directions.
  const double h = 1. / 16.;
  EXPECT_NEAR(stable_step("2"), 0.4 * h / (150. + 100.), 1e-12);
  EXPECT_NEAR(stable_step("3"), 0.5 * stable_step("2"), 1e-12);
}


TEST(Positivity, MassFractionsStayBetweenZeroAndOne)
{
  for (const std::string limiter : {"mc", "superbee"})
  {
    const std::vector<std::string> lines =
      products_in_air() + std::vector<std::string>{"Method/Limiter=" + limiter};
    EXPECT_LT(largest_excess<1>(finite_volume(8) + lines, 200), 1e-12);
    EXPECT_LT(largest_excess<2>(finite_volume(8) + lines, 60), 1e-12);
    EXPECT_LT(largest_excess<1>(galerkin(3) + lines, 200), 1e-12);
    EXPECT_LT(largest_excess<2>(galerkin(2) + lines, 60), 1e-12);
  }
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "gas_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
template <int dim>
GasState<dim> gas_at_rest()
{
  GasState<dim> state;
  state.density = 1.225;
  state.pressure = 101325.;
  return state;
}


/// Gas at rest keeps every bit over 100 steps.
template <int dim>
void check_rest(const std::vector<std::string> &lines,
                const GasState<dim> &state = gas_at_rest<dim>())
{
  GasRun<dim> run(lines +
                  std::vector<std::string>{"Domain/Initial refinement=2",
                                           "Domain/Upper corner=0.7, 0.9, 1.1",
                                           "Boundaries/y high=open",
                                           "Boundaries/x high=open"});
  if (dim > 1)
    run.refine([](const Point<dim> &p) { return p.norm() < 0.6; });
  EXPECT_EQ(run.mesh.hanging_faces().empty(), dim == 1);
  run.set_state([&](const Point<dim> &) { return state; });
  // The same numbers in every point, whatever sampling made of them.
  const auto u = conserved_state(state, run.material, run.layout.n_components);
  std::vector<double> values;
  for (const double x : u)
    values.insert(values.end(), run.layout.n_points, x);
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    run.field.set_leaf(leaf, values);
  run.field.fill_padding(run.mesh.n_owned());
  run.stepper->reinit(run.field);

  run.steps(100);
  unsigned int n_changed = 0;
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
  {
    const auto now = run.field.leaf(leaf);
    for (unsigned int i = 0; i < values.size(); ++i)
      n_changed += now[i] != values[i];
  }
  EXPECT_EQ(n_changed, 0u);
}


/// Uniform gas that moves stays uniform over 20 steps.
template <int dim>
void check_uniform_flow(const std::vector<std::string> &lines,
                        GasState<dim> state)
{
  GasRun<dim> run(lines +
                  std::vector<std::string>{"Domain/Periodic directions=x, y" +
                                             std::string(dim == 3 ? ", z" : ""),
                                           "Domain/Coarse leaves=2, 2, 2",
                                           "Domain/Initial refinement=1"});
  run.refine([](const Point<dim> &p) { return p.norm() < 0.6; });
  for (unsigned int d = 0; d < dim; ++d)
    state.velocity[d] = 200. - 170. * d;
  run.set_state([&](const Point<dim> &) { return state; });
  run.steps(20);
  const auto u = conserved_state(state, run.material, run.layout.n_components);
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
  {
    const auto values = run.field.leaf(leaf);
    const double momentum = state.density * state.velocity.norm();
    for (unsigned int i = 0; i < values.size(); ++i)
    {
      const unsigned int c = i / run.layout.n_points;
      const double scale = c >= 1 && c <= dim ? momentum : u[c];
      ASSERT_NEAR(values[i], u[c], 1e-12 * scale);
    }
  }
}


/// States of a mixture: air, products, and half of each.
template <int dim>
std::vector<GasState<dim>> mixtures()
{
  std::vector<GasState<dim>> result;
  for (const double products : {0., 0.5, 1.})
  {
    GasState<dim> state = gas_at_rest<dim>();
    state.density = 1.2 + 300. * products;
    state.pressure = 1e5 + 1e9 * products;
    state.products = products;
    result.push_back(state);
  }
  return result;
}
} // namespace


TEST(GasAtRest, OneDimensionalGeometries)
{
  for (const std::string geometry : {"plane", "cylindrical", "spherical"})
    for (const unsigned int n : {1U, 4U, 8U})
      for (const std::string lower : {"0", "0.1"})
        check_rest<1>(finite_volume(n) +
                      std::vector<std::string>{"Domain/Geometry=" + geometry,
                                               "Domain/Lower corner=" + lower,
                                               "Domain/Coarse leaves=3"});
  for (const std::string geometry : {"plane", "cylindrical", "spherical"})
    for (const unsigned int degree : {1U, 2U, 3U, 4U, 5U})
      for (const std::string lower : {"0", "0.1"})
        check_rest<1>(galerkin(degree) +
                      std::vector<std::string>{"Domain/Geometry=" + geometry,
                                               "Domain/Lower corner=" + lower,
                                               "Domain/Coarse leaves=3"});
}


TEST(GasAtRest, PlaneWithHangingFaces)
{
  for (const unsigned int n : {1U, 2U, 8U})
    check_rest<2>(finite_volume(n));
  for (const unsigned int degree : {1U, 2U, 3U, 4U, 5U})
    check_rest<2>(galerkin(degree));
}


TEST(GasAtRest, AxisymmetricWithHangingFaces)
{
  for (const std::string lower : {"0, 0", "0.05, -0.1"})
  {
    const std::vector<std::string> vessel = {"Domain/Geometry=axisymmetric",
                                             "Domain/Lower corner=" + lower};
    for (const unsigned int n : {1U, 2U, 8U})
      check_rest<2>(finite_volume(n) + vessel);
    for (const unsigned int degree : {1U, 2U, 3U, 4U, 5U})
      check_rest<2>(galerkin(degree) + vessel);
  }
}


TEST(GasAtRest, SpaceWithHangingFaces)
{
  check_rest<3>(finite_volume(4));
  check_rest<3>(galerkin(1));
  check_rest<3>(galerkin(3));
}


TEST(GasAtRest, ProductsInAir)
{
  for (const auto &state : mixtures<2>())
  {
    check_rest<2>(finite_volume(4) + products_in_air(), state);
    check_rest<2>(galerkin(3) + products_in_air(), state);
  }
  for (const auto &state : mixtures<1>())
    for (const auto &method : {finite_volume(8), galerkin(3)})
      check_rest<1>(method + products_in_air() +
                      std::vector<std::string>{"Domain/Geometry=spherical"},
                    state);
}


TEST(UniformFlow, StaysAcrossHangingFaces)
{
  for (const unsigned int n : {1U, 2U, 8U})
    check_uniform_flow<2>(finite_volume(n), gas_at_rest<2>());
  for (const unsigned int degree : {1U, 2U, 3U, 4U, 5U})
    check_uniform_flow<2>(galerkin(degree), gas_at_rest<2>());
  check_uniform_flow<3>(finite_volume(4), gas_at_rest<3>());
  check_uniform_flow<3>(galerkin(2), gas_at_rest<3>());
}


TEST(UniformFlow, ProductsInAir)
{
  for (const auto &state : mixtures<2>())
  {
    check_uniform_flow<2>(finite_volume(4) + products_in_air(), state);
    check_uniform_flow<2>(galerkin(3) + products_in_air(), state);
  }
}

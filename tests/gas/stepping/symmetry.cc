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
using Map = std::function<Point<dim>(const Point<dim> &)>;


/// Flow without any symmetry, with a shock.
template <int dim>
GasState<dim> flow(const Point<dim> &p)
{
  GasState<dim> state;
  state.density = 1.5 + 0.5 * ripple(p[0], 1) * ripple(p[dim - 1], 2);
  state.pressure = 1e5 * (2. + ripple(p[0] + 2. * p[dim - 1], 3));
  if (p.norm() < 0.5)
    state.pressure *= 5.;
  for (unsigned int d = 0; d < dim; ++d)
    state.velocity[d] = 200. * ripple(p[(d + 1) % dim] + 0.3 * p[d], d + 2);
  return state;
}


template <int dim>
using Turn =
  std::function<dealii::Tensor<1, dim>(const dealii::Tensor<1, dim> &)>;


/// A place, to be found again in spite of round-off.
template <int dim>
std::array<long, dim> key(const Point<dim> &p)
{
  std::array<long, dim> result;
  for (unsigned int d = 0; d < dim; ++d)
    result[d] = std::lround(1.2345678e6 * p[d]);
  return result;
}


/// A place and the conserved quantities there.
template <int dim>
using PointValue = std::pair<Point<dim>, std::vector<double>>;


template <int dim>
std::vector<PointValue<dim>> point_values(const GasRun<dim> &run)
{
  std::vector<PointValue<dim>> result;
  const unsigned int n_points = run.layout.n_points;
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
  {
    const auto values = run.field.leaf(leaf);
    const auto box = leaf_box(run.mesh, leaf);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      Point<dim> x;
      const auto index = run.points.indices(q);
      // Slightly inside the leaf, so that shared nodes stay apart.
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = 0.5 + 0.99 * (run.points.position(index[d]) - 0.5);
      std::vector<double> u;
      for (unsigned int c = 0; c < run.layout.n_components; ++c)
        u.push_back(values[c * n_points + q]);
      result.push_back({box.place(x), u});
    }
  }
  return result;
}


/// Largest relative difference of two states, the first one turned.
template <int dim>
double difference(const std::vector<double> &u,
                  const std::vector<double> &v,
                  const Turn<dim> &turn)
{
  dealii::Tensor<1, dim> momentum;
  for (unsigned int d = 0; d < dim; ++d)
    momentum[d] = u[1 + d];
  momentum = turn(momentum);
  double largest = std::max(std::abs(u[0] - v[0]) / u[0],
                            std::abs(u[dim + 1] - v[dim + 1]) / u[dim + 1]);
  for (unsigned int d = 0; d < dim; ++d)
    largest = std::max(
      largest, std::abs(momentum[d] - v[1 + d]) / std::sqrt(u[0] * u[dim + 1]));
  return largest;
}


/// Largest relative difference between a run and the run of the mapped
/// flow; @p map moves places and is its own inverse, @p turn velocities.
template <int dim>
double largest_difference(const std::vector<std::string> &method,
                          const Map<dim> &map,
                          const Turn<dim> &turn)
{
  const std::vector<std::string> box = {"Domain/Initial refinement=2"};
  GasRun<dim> run(box + method), image(box + method);
  const auto refined = [](const Point<dim> &p) {
    return p[0] < 0.5 && p[dim - 1] > 0.25;
  };
  run.refine(refined);
  image.refine([&](const Point<dim> &p) { return refined(map(p)); });
  run.set_state(flow<dim>);
  image.set_state([&](const Point<dim> &p) {
    GasState<dim> state = flow<dim>(map(p));
    state.velocity = turn(state.velocity);
    return state;
  });
  run.steps(20);
  image.steps(20);
  EXPECT_NEAR(run.time, image.time, 1e-12 * run.time);

  std::map<std::array<long, dim>, std::vector<double>> images;
  for (const auto &[place, u] : point_values(image))
    images[key(place)] = u;
  double largest = 0.;
  for (const auto &[place, u] : point_values(run))
  {
    const auto found = images.find(key(map(place)));
    if (found == images.end())
    {
      ADD_FAILURE() << "no image of " << place;
      return 1.;
    }
    largest = std::max(largest, difference<dim>(u, found->second, turn));
  }
  return largest;
}


template <int dim>
double mirrored(const std::vector<std::string> &method,
                const unsigned int direction)
{
  return largest_difference<dim>(
    method,
    [=](Point<dim> p) {
      p[direction] = 1. - p[direction];
      return p;
    },
    [=](dealii::Tensor<1, dim> v) {
      v[direction] *= -1.;
      return v;
    });
}


template <int dim>
double exchanged(const std::vector<std::string> &method,
                 const unsigned int a,
                 const unsigned int b)
{
  return largest_difference<dim>(
    method,
    [=](Point<dim> p) {
      std::swap(p[a], p[b]);
      return p;
    },
    [=](dealii::Tensor<1, dim> v) {
      std::swap(v[a], v[b]);
      return v;
    });
}


/// Round-off, which 20 steps with limiters and a shock may amplify.
const double round_off = 1e-11;
} // namespace


TEST(Symmetry, MirroredFlowsStayMirrored)
{
  for (const auto &method : {finite_volume(4), galerkin(2)})
    for (const unsigned int d : {0U, 1U})
      EXPECT_LT(mirrored<2>(method, d), round_off);
  for (const auto &method : {finite_volume(2), galerkin(1)})
    for (const unsigned int d : {0U, 1U, 2U})
      EXPECT_LT(mirrored<3>(method, d), round_off);
}


TEST(Symmetry, DirectionsAreAlike)
{
  for (const auto &method : {finite_volume(1),
                             finite_volume(8),
                             galerkin(1),
                             galerkin(3),
                             finite_volume(4) + products_in_air(),
                             galerkin(2) + products_in_air()})
    EXPECT_LT(exchanged<2>(method, 0, 1), round_off);
  for (const auto &method : {finite_volume(2), galerkin(1)})
  {
    EXPECT_LT(exchanged<3>(method, 0, 1), round_off);
    EXPECT_LT(exchanged<3>(method, 1, 2), round_off);
    EXPECT_LT(exchanged<3>(method, 0, 2), round_off);
  }
}


TEST(Symmetry, EveryFlux)
{
  for (const std::string &flux : names_of(riemann_fluxes))
  {
    const std::vector<std::string> line = {"Method/Flux=" + flux};
    for (const auto &method : {finite_volume(4), galerkin(2)})
    {
      EXPECT_LT(mirrored<2>(method + line, 0), round_off) << flux;
      EXPECT_LT(exchanged<2>(method + line, 0, 1), round_off) << flux;
    }
  }
}


TEST(Symmetry, OneDimensionalFlowIsTheSameInEveryDimension)
{
  // The same problem along a line, across a plane and across space.
  const auto pressure_wave = [](const double x) {
    return 1e5 * (1. + std::exp(-100. * (x - 0.4) * (x - 0.4)));
  };
  for (const auto &method : {finite_volume(8), galerkin(3)})
  {
    const std::vector<std::string> box = {"Domain/Coarse leaves=4, 1, 1",
                                          "Domain/Upper corner=1, 0.25, 0.25"};
    GasRun<1> line(method + box);
    GasRun<3> space(method + box);
    line.set_state([&](const Point<1> &p) {
      GasState<1> state;
      state.pressure = pressure_wave(p[0]);
      return state;
    });
    space.set_state([&](const Point<3> &p) {
      GasState<3> state;
      state.pressure = pressure_wave(p[0]);
      return state;
    });
    const double step = 0.3 * space.stepper->stable_step();
    for (unsigned int i = 0; i < 20; ++i)
    {
      line.stepper->advance(line.field, 0., step);
      space.stepper->advance(space.field, 0., step);
    }
    const unsigned int n = line.layout.n;
    for (unsigned int leaf = 0; leaf < space.mesh.n_owned(); ++leaf)
    {
      const auto u = space.field.leaf(leaf);
      const unsigned int slab = space.mesh.cell(leaf)->center()[0] * 4.;
      const auto v = line.field.leaf(slab);
      for (unsigned int q = 0; q < space.layout.n_points; ++q)
      {
        EXPECT_NEAR(u[q], v[q % n], 1e-12);
        EXPECT_NEAR(u[4 * n * n * n + q], v[2 * n + q % n], 1e-12 * 2.5e5);
        EXPECT_NEAR(u[2 * n * n * n + q], 0., 1e-9);
      }
    }
  }
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/state/point_sampler.h>

#include "gas_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
/// Density linear in space; momentum and energy follow it.
template <int dim>
GasState<dim> linear_gas(const Point<dim> &p)
{
  GasState<dim> state;
  state.density = 2.;
  state.pressure = 1e5;
  for (unsigned int d = 0; d < dim; ++d)
    state.density += 0.3 * (d + 1.) * p[d];
  return state;
}


template <int dim>
std::vector<Point<dim>> places()
{
  std::vector<Point<dim>> result;
  for (unsigned int i = 0; i < 20; ++i)
  {
    Point<dim> p;
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = std::fmod(0.137 + 0.618 * i * (d + 1), 1.);
    result.push_back(p);
  }
  return result;
}


template <int dim>
void check_linear(const std::vector<std::string> &method)
{
  GasRun<dim> run(method +
                  std::vector<std::string>{"Domain/Coarse leaves=3, 2, 2",
                                           "Domain/Initial refinement=1"});
  if (dim > 1)
    run.refine([](const Point<dim> &p) { return p.norm() < 0.7; });
  run.set_state(linear_gas<dim>);
  PointSampler<dim> sampler;
  sampler.reinit(places<dim>(), run.mesh, run.points);
  const auto states = sampler.sample(run.field, run.material);
  ASSERT_EQ(states.size(), 20u);
  unsigned int n_compared = 0;
  for (unsigned int i = 0; i < states.size(); ++i)
  {
    const auto exact = linear_gas(places<dim>()[i]);
    // Between the outermost centres of a finite-volume leaf and its rim the
    // value stays constant: off by at most half a subcell's slope.
    const double bound =
      run.points.is_galerkin() ? 1e-9 : 0.3 * dim * dim / 16.;
    EXPECT_NEAR(states[i].density, exact.density, bound);
    EXPECT_NEAR(states[i].pressure, exact.pressure, 1e-9 * exact.pressure);
    if (std::abs(states[i].density - exact.density) < 1e-9)
      ++n_compared;
  }
  EXPECT_GT(n_compared, 5u);
}
} // namespace


TEST(PointSampler, LinearFieldsAreExact)
{
  check_linear<1>(finite_volume(8));
  check_linear<2>(finite_volume(8));
  check_linear<3>(finite_volume(8));
  for (const unsigned int degree : {1U, 2U, 3U})
  {
    check_linear<1>(galerkin(degree));
    check_linear<2>(galerkin(degree));
    check_linear<3>(galerkin(degree));
  }
}


TEST(PointSampler, CornersAndFacesBelongToOneLeaf)
{
  GasRun<2> run(galerkin(2) +
                std::vector<std::string>{"Domain/Initial refinement=2"});
  run.set_state(linear_gas<2>);
  const std::vector<Point<2>> corners = {
    {0., 0.}, {1., 1.}, {0.5, 0.5}, {0.25, 1.}, {0.75, 0.1}, {0.5, 0.}};
  PointSampler<2> sampler;
  sampler.reinit(corners, run.mesh, run.points);
  const auto states = sampler.sample(run.field, run.material);
  for (unsigned int i = 0; i < corners.size(); ++i)
    EXPECT_NEAR(states[i].density, linear_gas(corners[i]).density, 1e-9);
}


TEST(PointSampler, TheNumberOfRanksDoesNotMatter)
{
  const auto sample = [](const MPI_Comm communicator) {
    GasRun<2> run(finite_volume(4) +
                    std::vector<std::string>{"Domain/Initial refinement=3"},
                  communicator);
    run.refine([](const Point<2> &p) { return p.norm() < 0.4; });
    run.set_state([](const Point<2> &p) {
      GasState<2> state;
      state.density = 1.5 + ripple(p[0], 1) * ripple(p[1], 2);
      state.pressure = 1e5 * (2. + ripple(p[0] + p[1], 3));
      state.velocity[0] = 100. * ripple(p[1], 4);
      return state;
    });
    PointSampler<2> sampler;
    sampler.reinit(places<2>(), run.mesh, run.points);
    return sampler.sample(run.field, run.material);
  };
  const auto alone = sample(MPI_COMM_SELF);
  const auto together = sample(MPI_COMM_WORLD);
  ASSERT_EQ(alone.size(), together.size());
  for (unsigned int i = 0; i < alone.size(); ++i)
  {
    EXPECT_EQ(alone[i].density, together[i].density);
    EXPECT_EQ(alone[i].pressure, together[i].pressure);
    EXPECT_EQ(alone[i].velocity, together[i].velocity);
  }
}


TEST(PointSampler, AdaptationElsewhereDoesNotMatter)
{
  GasRun<2> run(finite_volume(8) +
                std::vector<std::string>{"Domain/Initial refinement=2"});
  const std::vector<Point<2>> place = {{0.3, 0.2}};
  const auto sample = [&]() {
    run.set_state(linear_gas<2>);
    PointSampler<2> sampler;
    sampler.reinit(place, run.mesh, run.points);
    return sampler.sample(run.field, run.material)[0].density;
  };
  const double before = sample();
  run.refine([](const Point<2> &p) { return p[0] > 0.5 && p[1] > 0.5; });
  EXPECT_EQ(sample(), before);
}

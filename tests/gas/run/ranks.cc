// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "gas_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
/// Ten steps with hanging faces give the same bits on one rank and on all.
template <int dim>
void check(const std::vector<std::string> &lines)
{
  const auto make = [&](const MPI_Comm communicator) {
    auto run = std::make_unique<GasRun<dim>>(
      lines + std::vector<std::string>{"Domain/Initial refinement=2",
                                       "Domain/Periodic directions=y",
                                       "Boundaries/x high=open"},
      communicator);
    run->refine(
      [](const Point<dim> &p) { return std::abs(p.norm() - 0.7) < 0.2; });
    run->set_state([](const Point<dim> &p) {
      GasState<dim> state;
      state.density = 1.5 + ripple(p[0], 1) * ripple(p[1], 2);
      state.pressure = p[0] + p[1] < 0.9 ? 2e6 : 1e5;
      state.velocity[0] = 100. * ripple(p[1], 4);
      state.products = 0.5 + 0.5 * ripple(p[0], 1);
      return state;
    });
    for (unsigned int i = 0; i < 10; ++i)
      EXPECT_EQ(run->step().retries, 0u);
    return run;
  };
  const auto alone = make(MPI_COMM_SELF);
  const auto together = make(MPI_COMM_WORLD);
  EXPECT_EQ(alone->time, together->time);
  const auto all = alone->leaves();
  for (const auto &[name, values] : together->leaves())
  {
    ASSERT_TRUE(all.count(name)) << name;
    EXPECT_EQ(values, all.at(name)) << name;
  }
  const auto one = alone->totals();
  for (const auto &[name, value] : together->totals())
    EXPECT_NEAR(value, one.at(name), 1e-12 * (1. + std::abs(one.at(name))))
      << name;
}
} // namespace


TEST(Ranks, FiniteVolumes)
{
  check<2>(finite_volume(8));
  check<2>(finite_volume(4) +
           std::vector<std::string>{"Domain/Geometry=axisymmetric"});
  check<2>(finite_volume(4) + products_in_air());
  check<3>(finite_volume(4));
}


TEST(Ranks, FewerLeavesThanRanks)
{
  // A rank without leaves takes part in everything.
  for (const std::string periodic : {"", "x, y"})
  {
    GasRun<2> run(finite_volume(8) + std::vector<std::string>{
                                       "Domain/Periodic directions=" + periodic,
                                       "Adaptation/Active=true",
                                       "Adaptation/Largest level=2"});
    EXPECT_EQ(run.mesh.n_global(), 1.);
    run.set_state([](const Point<2> &p) {
      GasState<2> state;
      state.pressure = p.norm() < 0.5 ? 5. : 1.;
      return state;
    });
    const auto before = run.totals();
    run.steps(3);
    EXPECT_TRUE(run.adapt());
    run.steps(3);
    for (const std::string name : {"mass", "energy"})
      EXPECT_NEAR(
        run.totals().at(name), before.at(name), 1e-13 * before.at(name));
  }
}


TEST(Ranks, Galerkin)
{
  check<2>(galerkin(3));
  check<2>(galerkin(1) + products_in_air());
  check<3>(galerkin(2));
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/scheme/runge_kutta.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;

namespace
{
/// Error at time 1 of u' = -u + cos(3 t), u(0) = 2.
double error(const RungeKuttaTable &table, const unsigned int n_steps)
{
  const auto exact = [](const double t) {
    return 0.1 * (std::cos(3. * t) + 3. * std::sin(3. * t)) +
           1.9 * std::exp(-t);
  };
  const double step = 1. / n_steps;
  double u = exact(0.);
  for (unsigned int n = 0; n < n_steps; ++n)
  {
    const double initial = u;
    for (const RungeKuttaStage &stage : table.stages)
    {
      const double t = (n + stage.time) * step;
      u = stage.initial_weight * initial +
          stage.step_weight * (u + step * (std::cos(3. * t) - u));
    }
  }
  return std::abs(u - exact(1.));
}
} // namespace


TEST(RungeKutta, ConvergesAtItsOrder)
{
  unsigned int order = 1;
  for (const std::string &name : runge_kutta_names())
  {
    SCOPED_TRACE(name);
    const RungeKuttaTable table = parse_runge_kutta(name);
    EXPECT_EQ(table.order, order++);
    const double rate = std::log2(error(table, 100) / error(table, 200));
    EXPECT_NEAR(rate, table.order, 0.05);
  }
}


// Convex combinations of Euler steps, and stage times that belong to them.
TEST(RungeKutta, IsStrongStabilityPreserving)
{
  for (const std::string &name : runge_kutta_names())
  {
    SCOPED_TRACE(name);
    double time = 0.;
    for (const RungeKuttaStage &stage : parse_runge_kutta(name).stages)
    {
      EXPECT_GE(stage.initial_weight, 0.);
      EXPECT_GE(stage.step_weight, 0.);
      EXPECT_NEAR(stage.initial_weight + stage.step_weight, 1., 1e-16);
      EXPECT_NEAR(stage.time, time, 1e-15);
      time = stage.step_weight * (time + 1.);
    }
    EXPECT_NEAR(time, 1., 1e-15);
  }
}


TEST(RungeKutta, RefusesUnknownNames)
{
  EXPECT_THROW(parse_runge_kutta("rk4"), InputError);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/exact/detonation_solution.h>

#include <gtest/gtest.h>

using namespace contrecoup;

namespace
{
const JwlParameters &tnt()
{
  return find_explosive("tnt").jwl;
}

/// Mass of the gas per unit angle and t^dimension, from xi = 0 to D.
double mass(const DetonationSolution &solution, const unsigned int dimension)
{
  const unsigned int n = 200000;
  const double step = solution.front().detonation_speed / n;
  double sum = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double xi = (i + 0.5) * step;
    sum += solution.value(xi).density * std::pow(xi, dimension - 1.) * step;
  }
  return sum;
}
} // namespace


// Core pressure over that of the front and core radius over D t, which were
// integrated by other means before.
TEST(DetonationSolution, CoreOfTnt)
{
  const DetonationSolution plane(1, tnt()), sphere(3, tnt());
  const double speed = sphere.front().detonation_speed;
  const double pressure = sphere.front().pressure;
  EXPECT_NEAR(plane.core_speed() / speed, 0.522, 1e-3);
  EXPECT_NEAR(plane.value(0.).pressure / pressure, 0.269, 1e-3);
  EXPECT_NEAR(sphere.core_speed() / speed, 0.471, 1e-3);
  EXPECT_NEAR(sphere.value(0.).pressure / pressure, 0.201, 1e-3);
  EXPECT_NEAR(sphere.value(0.).density / 1630., 0.822, 1e-3);
}


TEST(DetonationSolution, BeginsAtTheChapmanJouguetState)
{
  for (unsigned int dimension = 1; dimension <= 3; ++dimension)
  {
    const DetonationSolution solution(dimension, tnt());
    const auto front = solution.front();
    const RadialState state = solution.value(front.detonation_speed);
    EXPECT_NEAR(state.pressure, front.pressure, 1e-9 * front.pressure);
    EXPECT_NEAR(state.velocity, front.velocity, 1e-9 * front.velocity);
    EXPECT_EQ(solution.value(0.1).velocity, 0.);
  }
}


// All explosive that the front has passed is behind it.
TEST(DetonationSolution, ConservesMass)
{
  for (const std::string name : {"tnt", "c-4", "anfo"})
    for (unsigned int dimension = 1; dimension <= 3; ++dimension)
    {
      const JwlParameters &jwl = find_explosive(name).jwl;
      const DetonationSolution solution(dimension, jwl);
      const double whole =
        jwl.reference_density *
        std::pow(solution.front().detonation_speed, dimension) / dimension;
      EXPECT_NEAR(mass(solution, dimension), whole, 1e-4 * whole)
        << name << " in " << dimension << " dimensions";
    }
}


TEST(DetonationSolution, RefusesOtherDimensions)
{
  EXPECT_THROW(DetonationSolution(4, tnt()), InputError);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/rigid_sphere_solution.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;

namespace
{
/// Largest pressure at the wall in front over that of a slow deceleration.
double peak_factor(const double duration)
{
  RigidSphere sphere;
  sphere.duration = duration;
  const RigidSphereSolution solution(sphere);
  double peak = 0.;
  for (double time = 0.3 * duration; time < duration; time += 2e-3 * duration)
    peak = std::max(peak, solution.pressure(sphere.radius, 1., time));
  return peak / (sphere.density * sphere.deceleration * sphere.radius);
}
} // namespace

TEST(RigidSphereSolution, has_the_tabulated_roots)
{
  const RigidSphereSolution solution(RigidSphere(), 4);
  const double expected[] = {2.0816, 5.9404, 9.2058, 12.4044};
  for (unsigned int n = 0; n < 4; ++n)
    EXPECT_NEAR(solution.roots()[n], expected[n], 5e-5);
}

// The sum of 2 / (a^2 - 2) is one: the pressure of a slow deceleration is
// hydrostatic.
TEST(RigidSphereSolution, slow_decelerations_are_hydrostatic)
{
  RigidSphere sphere;
  sphere.duration = 0.05;
  const RigidSphereSolution solution(sphere);
  for (const double part : {0.3, 0.7, 1.})
    EXPECT_NEAR(solution.pressure(part * sphere.radius, 0.5, 0.025),
                0.5 * part * sphere.density * sphere.deceleration *
                  sphere.radius,
                2e-3 * sphere.density * sphere.deceleration * sphere.radius);
}

// Sums of 2000 modes by another program; 200 lack a thousandth.
TEST(RigidSphereSolution, shorter_ones_have_higher_peaks)
{
  EXPECT_NEAR(peak_factor(2e-4), 1.5926, 1.2e-3);
  EXPECT_NEAR(peak_factor(1e-3), 1.0876, 1.2e-3);
  EXPECT_NEAR(peak_factor(2e-3), 1.0368, 1.2e-3);
}

// Nothing is known in the centre before sound has come from the wall.
TEST(RigidSphereSolution, pressure_comes_with_sound)
{
  const RigidSphere sphere;
  const RigidSphereSolution solution(sphere);
  const double arrival = 0.5 * sphere.radius / sphere.sound_speed;
  const double scale = sphere.density * sphere.deceleration * sphere.radius;
  EXPECT_NEAR(solution.pressure(0.5 * sphere.radius, 1., 0.9 * arrival) / scale,
              0.,
              1e-4);
  EXPECT_GT(solution.pressure(0.5 * sphere.radius, 1., 2. * arrival) / scale,
            0.01);
}

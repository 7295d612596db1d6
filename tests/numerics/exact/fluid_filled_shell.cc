// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/fluid_filled_shell.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;

TEST(FluidFilledShell, is_a_mass_on_a_spring)
{
  const FluidFilledShell shell;
  EXPECT_NEAR(shell.mass(), 3.14356, 1e-5);
  EXPECT_NEAR(shell.stiffness(), 9.139e6, 1e3);
  const double rate = std::acos(-1.) / shell.contact_time();
  // Its kinetic energy is all in the spring when it turns.
  EXPECT_NEAR(std::pow(shell.peak_force(), 2) / shell.stiffness(),
              shell.mass() * shell.speed * shell.speed,
              1e-12);
  EXPECT_NEAR(shell.peak_acceleration(), shell.speed * rate, 1e-9);
}

// All parts of the dent make the wall stand still where it touches, but for
// what a shallow shell neglects.
TEST(FluidFilledShell, stands_still_where_it_touches)
{
  const FluidFilledShell shell;
  double sum = 0.;
  for (unsigned int l = 0; l < 1000; ++l)
    sum += shell.dent(l);
  EXPECT_NEAR(sum, 1., 2e-3);
  // A part is the integral of kei over the sphere; of l = 0, 2 (L / R)^2 / pi.
  EXPECT_NEAR(shell.dent(0), 2. / std::acos(-1.) * 0.025107, 1e-5);
}

// The numbers are sums by another program.
TEST(FluidFilledShell, is_hydrostatic_inside_and_less_at_the_poles)
{
  const FluidFilledShell shell;
  const double scale =
    shell.fluid_density * shell.peak_acceleration() * shell.fluid_radius;
  EXPECT_NEAR(shell.pressure(0.079, 1.) / scale, 0.91962, 1e-5);
  EXPECT_NEAR(shell.pressure(0.0768, 1.) / scale, 0.90317, 1e-5);
  EXPECT_NEAR(shell.pressure(0.040, 1.) / scale, 0.50105, 1e-5);
  EXPECT_NEAR(shell.pressure(0.01, 0.3) / scale, 0.3 * 0.01 / 0.079, 1e-4);
  EXPECT_NEAR(
    shell.pressure(0.04, -1.), -shell.pressure(0.04, 1.), 1e-9 * scale);
}

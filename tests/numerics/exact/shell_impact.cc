// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/shell_impact.h>

#include <gtest/gtest.h>

using namespace contrecoup;

// Published figures: bone of 6.5 GPa and 7 mm, R = 90 mm, 4.5 kg at 3 m/s give
// 18 kN, 2.3 ms and 368 kPa.
TEST(ShellImpact, has_the_figures_of_a_head)
{
  const ShellImpact head{4.5, 0.09, 0.007, 6.5e9, 0.22, 3.};
  EXPECT_NEAR(head.peak_force(), 18.4e3, 0.1e3);
  EXPECT_NEAR(head.contact_time(), 2.30e-3, 0.01e-3);
  EXPECT_NEAR(head.peak_pressure(1000., 0.09), 368e3, 1e3);
}

// Half a sine of the force takes the momentum away, and gives it back.
TEST(ShellImpact, turns_the_momentum)
{
  const ShellImpact shell{2., 0.05, 0.002, 1e9, 0.3, 5.};
  EXPECT_NEAR(2. / dealii::numbers::PI * shell.peak_force() *
                shell.contact_time(),
              2. * shell.mass * shell.speed,
              1e-12);
}

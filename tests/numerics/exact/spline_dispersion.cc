// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/spline_dispersion.h>

#include <gtest/gtest.h>

using namespace contrecoup;

// What another program measured in one dimension (FLIP, MUSL), of waves of 8
// and of 16 cells, lumped and with two and four terms of the series.
TEST(SplineDispersion, has_the_speeds_that_were_measured)
{
  const double measured[3][2] = {{0.97, 0.97}, {0.86, 0.96}, {0.81, 0.95}};
  for (unsigned int degree = 2; degree <= 3; ++degree)
    for (unsigned int i = 0; i < 2; ++i)
      EXPECT_NEAR(SplineDispersion(degree).speed(i == 0 ? 8. : 16.),
                  measured[degree - 1][i],
                  6e-3);
  const SplineDispersion cubic(3);
  EXPECT_NEAR(cubic.speed(8., 2), 0.966, 1e-3);
  EXPECT_NEAR(cubic.speed(16., 2), 0.998, 1e-3);
  EXPECT_NEAR(cubic.speed(8., 4), 0.999, 1e-3);
  EXPECT_NEAR(cubic.speed(16., 4), 1., 1e-3);
}

// Linear elements have (2 + cos q) / 3 and 2 - 2 cos q; a long wave goes with
// sound, with an error of order p by lumping and of 2 p without.
TEST(SplineDispersion, agrees_with_linear_elements_and_long_waves)
{
  const SplineDispersion linear(1);
  for (const double phase : {0.1, 1., 3.})
  {
    EXPECT_NEAR(linear.mass(phase), (2. + std::cos(phase)) / 3., 1e-15);
    EXPECT_NEAR(linear.stiffness(phase), 2. - 2. * std::cos(phase), 1e-15);
  }
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    const SplineDispersion spline(degree);
    EXPECT_NEAR(spline.mass(0.), 1., 1e-14);
    EXPECT_NEAR(spline.stiffness(1e-3) / 1e-6, 1., 1e-6);
    const double lumped =
      std::log2((1. - spline.speed(20.)) / (1. - spline.speed(40.)));
    EXPECT_NEAR(lumped, 2., 0.1) << degree;
    const double consistent = std::log2((spline.consistent_speed(12.) - 1.) /
                                        (spline.consistent_speed(24.) - 1.));
    EXPECT_NEAR(consistent, 2. * degree, 0.2) << degree;
    // The series comes to the consistent mass.
    EXPECT_NEAR(spline.speed(8., 60), spline.consistent_speed(8.), 1e-12);
  }
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lanes.h>

#include <contrecoup/numerics/element/spline_weights.h>

#include <gtest/gtest.h>

using namespace contrecoup;

namespace
{
template <typename Function>
void for_each_degree(const Function &function)
{
  function(std::integral_constant<unsigned int, 1>());
  function(std::integral_constant<unsigned int, 2>());
  function(std::integral_constant<unsigned int, 3>());
}

/// Sums over the splines at a place: of N, N i, N (i - x)^2, N', N' i.
template <unsigned int degree>
std::array<double, 5> moments(const double x)
{
  const SplineWeights w = spline_weights<degree>(x);
  std::array<double, 5> sums{};
  for (unsigned int i = 0; i < 4; ++i)
  {
    const double node = w.first + double(i);
    sums[0] += w.value[i];
    sums[1] += w.value[i] * node;
    sums[2] += w.value[i] * (node - x) * (node - x);
    sums[3] += w.slope[i];
    sums[4] += w.slope[i] * node;
  }
  return sums;
}
} // namespace

TEST(SplineWeights, sum_to_one_and_reproduce_linear_functions)
{
  for_each_degree([](const auto degree) {
    for (double x = -3.1; x < 3.; x += 0.0713)
    {
      SCOPED_TRACE(x);
      const auto sums = moments<degree>(x);
      EXPECT_NEAR(sums[0], 1., 1e-15);
      EXPECT_NEAR(sums[1], x, 4e-15);
      EXPECT_NEAR(sums[3], 0., 1e-15);
      EXPECT_NEAR(sums[4], 1., 4e-15);
      if (degree > 1)
      {
        EXPECT_NEAR(sums[2], spline_inertia(degree), 4e-15);
      }
    }
  });
}

TEST(SplineWeights, are_positive_and_reach_no_further_than_their_degree)
{
  for_each_degree([](const auto degree) {
    for (double x = -1.; x < 1.; x += 0.0625)
    {
      const SplineWeights w = spline_weights<degree>(x);
      for (unsigned int i = 0; i < 4; ++i)
      {
        EXPECT_GE(w.value[i], 0.);
        EXPECT_LE(w.value[i] != 0. ? std::abs(w.first + double(i) - x) : 0.,
                  0.5 * (degree + 1));
        if (i > degree)
        {
          EXPECT_EQ(w.value[i], 0.);
          EXPECT_EQ(w.slope[i], 0.);
        }
      }
    }
  });
}

TEST(SplineWeights, slopes_are_derivatives)
{
  const double step = 1e-5;
  for_each_degree([&](const auto degree) {
    for (double x = -2.033; x < 2.; x += 0.07)
    {
      const SplineWeights w = spline_weights<degree>(x),
                          lower = spline_weights<degree>(x - step),
                          upper = spline_weights<degree>(x + step);
      ASSERT_EQ(lower.first, upper.first);
      for (unsigned int i = 0; i < 4; ++i)
        EXPECT_NEAR(
          w.slope[i], (upper.value[i] - lower.value[i]) / (2. * step), 1e-9);
    }
  });
}

TEST(SplineWeights, are_the_same_in_lanes)
{
  for_each_degree([](const auto degree) {
    Lanes<double> f;
    for (unsigned int lane = 0; lane < n_lanes<double>; ++lane)
      f[lane] = (lane + 0.3) / (n_lanes<double> + 1.) - spline_shift(degree);
    const auto lanes = spline_weights_at<degree>(f);
    for (unsigned int lane = 0; lane < n_lanes<double>; ++lane)
    {
      const auto one = spline_weights_at<degree>(f[lane]);
      for (unsigned int i = 0; i < 4; ++i)
      {
        EXPECT_DOUBLE_EQ(lanes.value[i][lane], one.value[i]);
        EXPECT_DOUBLE_EQ(lanes.slope[i][lane], one.slope[i]);
      }
    }
  });
}

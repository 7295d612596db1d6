// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/scheme/limiters.h>
#include <contrecoup/numerics/scheme/multidimensional_limiter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace contrecoup;

namespace
{
// A limiter that limited_slope() does not know limits nothing.
std::vector<SlopeLimiter> named_limiters()
{
  std::vector<SlopeLimiter> limiters;
  for (const SlopeLimiterDescription &limiter : slope_limiters)
    limiters.push_back(limiter.kind);
  return limiters;
}

const std::vector<SlopeLimiter> all_limiters = named_limiters();

bool is_tvd(const SlopeLimiter kind)
{
  for (const SlopeLimiterDescription &limiter : slope_limiters)
    if (limiter.kind == kind)
      return limiter.is_tvd;
  return false;
}

/// Differences of both signs over many magnitudes, zero among them.
std::vector<double> differences()
{
  std::vector<double> values{0.};
  for (double size = 1e-12; size < 1e12; size *= 7.3)
  {
    values.push_back(size);
    values.push_back(-size);
  }
  return values;
}
} // namespace


// Sweby's region: between zero and twice the smaller difference, zero at an
// extremum. This makes the reconstruction total variation diminishing.
TEST(SlopeLimiter, StaysInTheTvdRegion)
{
  for (const SlopeLimiter limiter : all_limiters)
    for (const double a : differences())
      for (const double b : differences())
      {
        const double slope = limited_slope(limiter, a, b);
        ASSERT_TRUE(std::isfinite(slope));
        if (!is_tvd(limiter))
          EXPECT_EQ(slope, (a + b) * 0.5);
        else if (a * b <= 0.)
          EXPECT_EQ(slope, 0.);
        else
        {
          const double bound = 2. * std::min(std::abs(a), std::abs(b));
          EXPECT_GE(slope * a, 0.);
          EXPECT_LE(std::abs(slope), bound * (1. + 1e-15));
        }
      }
}


TEST(SlopeLimiter, IsSymmetricAndHomogeneous)
{
  for (const SlopeLimiter limiter : all_limiters)
    for (const double a : differences())
      for (const double b : differences())
      {
        const double slope = limited_slope(limiter, a, b);
        EXPECT_EQ(limited_slope(limiter, b, a), slope);
        EXPECT_EQ(limited_slope(limiter, -a, -b), -slope);
        EXPECT_DOUBLE_EQ(limited_slope(limiter, 4. * a, 4. * b), 4. * slope);
      }
}


TEST(SlopeLimiter, KeepsLinearFunctionsAndKnownValues)
{
  for (const SlopeLimiter limiter : all_limiters)
    EXPECT_DOUBLE_EQ(limited_slope(limiter, 0.3, 0.3), 0.3);
  EXPECT_EQ(limited_slope(SlopeLimiter::minmod, 1., 3.), 1.);
  EXPECT_DOUBLE_EQ(limited_slope(SlopeLimiter::van_albada, 1., 3.), 1.2);
  EXPECT_DOUBLE_EQ(limited_slope(SlopeLimiter::van_leer, 1., 3.), 1.5);
  EXPECT_EQ(limited_slope(SlopeLimiter::mc, 1., 2.), 1.5);
  EXPECT_EQ(limited_slope(SlopeLimiter::mc, 1., 5.), 2.);
  EXPECT_EQ(limited_slope(SlopeLimiter::superbee, 1., 1.5), 1.5);
  EXPECT_EQ(limited_slope(SlopeLimiter::superbee, 1., 5.), 2.);
}


TEST(SlopeLimiter, LanesAgreeWithPlainNumbers)
{
  using Number = Lanes<double>;
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> unit(-1., 1.);
  const SlopeWeights weights(0.2, 0.3, 0.08, 0.15);
  for (const SlopeLimiter limiter : all_limiters)
    for (unsigned int i = 0; i < 200; ++i)
    {
      Number a, b;
      for (unsigned int lane = 0; lane < Number::size(); ++lane)
      {
        a[lane] = lane == 1 ? 0. : unit(generator);
        b[lane] = lane == 2 ? 0. : unit(generator);
      }
      const Number slope = limited_slope(limiter, a, b);
      const Number uneven = limited_slope(limiter, a, b, weights);
      for (unsigned int lane = 0; lane < Number::size(); ++lane)
      {
        const double x = a[lane], y = b[lane];
        EXPECT_NEAR(slope[lane], limited_slope(limiter, x, y), 1e-15);
        EXPECT_NEAR(uneven[lane], limited_slope(limiter, x, y, weights), 1e-15);
      }
    }
  EXPECT_EQ(limited_slope(SlopeLimiter::van_leer, 1.f, 3.f), 1.5f);
  EXPECT_EQ(limited_slope(
              SlopeLimiter::van_leer, Lanes<float>(1.f), Lanes<float>(3.f))[0],
            1.5f);
}


// On any grid: a linear function keeps its slope, and the values at the cell's
// faces lie between the neighbours' values.
TEST(SlopeLimiter, BoundsFaceValuesOnUnevenGrids)
{
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> unit(0., 1.);
  for (const SlopeLimiter limiter : all_limiters)
    for (unsigned int i = 0; i < 5000; ++i)
    {
      const double backward_edge = 0.02 + unit(generator);
      const double forward_edge = 0.02 + unit(generator);
      const double to_backward = backward_edge + 0.02 + unit(generator);
      const double to_forward = forward_edge + 0.02 + unit(generator);
      const SlopeWeights weights(
        to_backward, to_forward, backward_edge, forward_edge);
      EXPECT_NEAR(limited_slope(limiter, -0.7, -0.7, weights), -0.7, 1e-15);
      if (!is_tvd(limiter))
        continue;
      const double a = 2. * unit(generator) - 1., b = 2. * unit(generator) - 1.;
      const double slope = limited_slope(limiter, a, b, weights);
      if (a * b <= 0.)
        EXPECT_EQ(slope, 0.);
      else
      {
        EXPECT_GE(slope * a, 0.);
        EXPECT_LE(std::abs(slope) * backward_edge,
                  std::abs(a) * to_backward * (1. + 1e-15));
        EXPECT_LE(std::abs(slope) * forward_edge,
                  std::abs(b) * to_forward * (1. + 1e-15));
      }
    }
}


TEST(SlopeLimiter, IsTheUniformOneOnAnEvenGrid)
{
  const SlopeWeights weights(1., 1., 0.5, 0.5);
  for (const SlopeLimiter limiter : all_limiters)
    for (const double a : {-2., -1., 0., 0.4, 3.})
      for (const double b : {-1.5, 0., 0.3, 1., 9.})
        EXPECT_DOUBLE_EQ(limited_slope(limiter, a, b, weights),
                         limited_slope(limiter, a, b));
}


TEST(GradientLimiter, BoundsTheFaceValue)
{
  for (const GradientLimiter limiter :
       {GradientLimiter::barth_jespersen, GradientLimiter::venkatakrishnan})
    for (const double below : {0., -1e-8, -0.3, -1e9})
      for (const double above : {0., 1e-8, 0.4, 1e9})
        for (const double increment : differences())
        {
          const double factor =
            gradient_limiter_factor(limiter, below, above, increment, 0.);
          ASSERT_TRUE(std::isfinite(factor));
          EXPECT_GE(factor, 0.);
          EXPECT_LE(factor, 1.);
          // Squares below the smallest float count as no change at all.
          const double rounding = 1e-15 * std::abs(increment) + 1e-19;
          EXPECT_LE(factor * increment, above + rounding);
          EXPECT_GE(factor * increment, below - rounding);
        }
}


TEST(GradientLimiter, KnowsItsValues)
{
  const auto factor = [](const GradientLimiter limiter,
                         const double increment,
                         const double plateau) {
    return gradient_limiter_factor(limiter, -1., 2., increment, plateau);
  };
  const auto barth_jespersen = GradientLimiter::barth_jespersen;
  EXPECT_EQ(factor(barth_jespersen, 0., 0.), 1.);
  EXPECT_EQ(factor(barth_jespersen, 1.5, 0.), 1.);
  EXPECT_EQ(factor(barth_jespersen, 4., 0.), 0.5);
  EXPECT_EQ(factor(barth_jespersen, -4., 0.), 0.25);

  // (y^2 + 2 y) / (y^2 + y + 2) with y = room / increment.
  const auto venkatakrishnan = GradientLimiter::venkatakrishnan;
  EXPECT_EQ(factor(venkatakrishnan, 0., 0.), 1.);
  EXPECT_DOUBLE_EQ(factor(venkatakrishnan, 2., 0.), 0.75);
  EXPECT_DOUBLE_EQ(factor(venkatakrishnan, -1., 0.), 0.75);
  EXPECT_EQ(factor(venkatakrishnan, 0.5, 0.), 1.);
  EXPECT_NEAR(factor(venkatakrishnan, 2., 1e9), 1., 1e-8);
}


TEST(Limiters, AreFoundByName)
{
  for (const auto &limiter : slope_limiters)
    EXPECT_EQ(find_choice(slope_limiters, limiter.name, "limiter"),
              limiter.kind);
  EXPECT_THROW(find_choice(slope_limiters, "no such limiter", "limiter"),
               InputError);
  EXPECT_EQ(find_choice(gradient_limiters, "venkatakrishnan", "limiter"),
            GradientLimiter::venkatakrishnan);
  EXPECT_THROW(find_choice(gradient_limiters, "none", "limiter"), InputError);
}

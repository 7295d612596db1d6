// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/finite_volume/sweep_line.h>

#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;
using namespace contrecoup::gas;

namespace
{
/// Differences of both signs, zeros and equal ones among them.
template <typename Real>
void expect_half_of_the_limited_slope()
{
  const FixedScheme scheme{Scheme()};
  std::mt19937 generator(1);
  std::uniform_real_distribution<Real> random(-2., 2.);
  for (unsigned int i = 0; i < 10000; ++i)
  {
    const Real a = i % 7 == 0 ? Real(0.) : random(generator);
    const Real b =
      i % 5 == 0 ? a : (i % 11 == 0 ? Real(0.) : random(generator));
    const Lanes<Real> half = scheme.half_slope(Lanes<Real>(a), Lanes<Real>(b));
    EXPECT_EQ(half[0], limited_slope(SlopeLimiter::mc, a, b) * Real(0.5))
      << a << " " << b;
  }
}
} // namespace


TEST(FixedScheme, HasTheSlopesOfTheLimiterToTheLastBit)
{
  expect_half_of_the_limited_slope<double>();
  expect_half_of_the_limited_slope<float>();
}


TEST(FixedScheme, IsTakenForItsOwnLimiterAndFluxAlone)
{
  Scheme scheme;
  scheme.limiter = SlopeLimiter::mc;
  scheme.flux = RiemannFlux::hllc_shock_stable;
  EXPECT_TRUE(FixedScheme::is(scheme));
  scheme.flux = RiemannFlux::rusanov;
  EXPECT_FALSE(FixedScheme::is(scheme));
  scheme.flux = RiemannFlux::hllc;
  scheme.limiter = SlopeLimiter::minmod;
  EXPECT_FALSE(FixedScheme::is(scheme));
  scheme.limiter = SlopeLimiter::mc;
  scheme.linear_reconstruction = false;
  EXPECT_FALSE(FixedScheme::is(scheme));
}

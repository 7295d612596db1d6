// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/exact/noh_solution.h>
#include <contrecoup/numerics/exact/sedov_solution.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace contrecoup;

// Energies alpha as J. R. Kamm and F. X. Timmes (LA-UR-07-2849) and LANL's
// ExactPack print them for gamma = 1.4 and 1.35.
TEST(SedovSolution, AlphaAgreesWithPublishedValues)
{
  const std::array<double, 3> diatomic{{0.538742792, 0.984074017, 0.851071855}};
  const std::array<double, 3> products{{0.622785, 1.132029, 0.976932}};
  for (unsigned int n = 1; n <= 3; ++n)
  {
    EXPECT_NEAR(SedovSolution(n, 1.4, 1., 1.).alpha(), diatomic[n - 1], 6e-10);
    EXPECT_NEAR(SedovSolution(n, 1.35, 1., 1.).alpha(), products[n - 1], 6e-7);
  }
}

TEST(SedovSolution, StrongShockRelationsHoldBehindTheShock)
{
  for (unsigned int n = 1; n <= 3; ++n)
    for (const double gamma : {1.2, 1.4, 5. / 3., 2., 3.})
    {
      const SedovSolution solution(n, gamma, 1.3, 2.);
      const double time = 0.7, radius = solution.shock_radius(time);
      // The closed form is singular at gamma = 2 and taken near it.
      const double tolerance = (gamma == 2.) ? 1e-5 : 1e-9;
      const double speed = 2. / (n + 2.) * radius / time;

      const RadialState behind = solution.value(radius * (1. - 1e-13), time);
      EXPECT_NEAR(
        behind.density / (1.3 * (gamma + 1.) / (gamma - 1.)), 1., tolerance);
      EXPECT_NEAR(behind.velocity / (2. * speed / (gamma + 1.)), 1., tolerance);
      EXPECT_NEAR(behind.pressure / (2. * 1.3 * speed * speed / (gamma + 1.)),
                  1.,
                  tolerance);

      const RadialState ahead = solution.value(radius * (1. + 1e-13), time);
      EXPECT_EQ(ahead.density, 1.3);
      EXPECT_EQ(ahead.velocity, 0.);
      EXPECT_EQ(ahead.pressure, 0.);
    }
}

// The profile holds all the mass swept up and all the energy released.
TEST(SedovSolution, ProfileHoldsMassAndEnergy)
{
  const std::array<double, 3> sphere{{1., 2. * M_PI, 4. * M_PI}};
  for (unsigned int n = 1; n <= 3; ++n)
    for (const double gamma : {1.3, 1.4, 2., 3.})
    {
      const SedovSolution solution(n, gamma, 1., 1.);
      const double radius = solution.shock_radius(1.);
      const unsigned int shells = 20000;

      double mass = 0., energy = 0.;
      for (unsigned int i = 0; i < shells; ++i)
      {
        const double r = (i + 0.5) / shells * radius;
        const RadialState s = solution.value(r, 1.);
        const double volume =
          sphere[n - 1] * std::pow(r, n - 1.) * radius / shells;
        mass += s.density * volume;
        energy += (0.5 * s.density * s.velocity * s.velocity +
                   s.pressure / (gamma - 1.)) *
                  volume;
      }
      EXPECT_NEAR(mass, sphere[n - 1] / n * std::pow(radius, n), 1e-6 * mass);
      EXPECT_NEAR(energy, 1., 1e-6);
    }
}

TEST(SedovSolution, ProfileIsFiniteAtTheCentre)
{
  for (unsigned int n = 1; n <= 3; ++n)
    for (const double gamma : {1.1, 1.4, 3., 6.9})
      for (const double r : {0., 1e-300, 1e-12, 1e-3})
      {
        const RadialState s = SedovSolution(n, gamma, 1., 1.).value(r, 1.);
        EXPECT_TRUE(std::isfinite(s.density) && s.density >= 0.);
        EXPECT_TRUE(std::isfinite(s.velocity));
        EXPECT_TRUE(std::isfinite(s.pressure) && s.pressure > 0.);
      }
}

TEST(SedovSolution, RefusesWhatHasNoSolution)
{
  EXPECT_THROW(SedovSolution(0, 1.4, 1., 1.), InputError);
  EXPECT_THROW(SedovSolution(4, 1.4, 1., 1.), InputError);
  EXPECT_THROW(SedovSolution(3, 1., 1., 1.), InputError);
  EXPECT_THROW(SedovSolution(3, 7., 1., 1.), InputError);
  EXPECT_THROW(SedovSolution(3, 1.4, 0., 1.), InputError);
  EXPECT_THROW(SedovSolution(3, 1.4, 1., std::nan("")), InputError);
}

TEST(NohSolution, AgreesWithPublishedStates)
{
  for (unsigned int n = 1; n <= 3; ++n)
  {
    const NohSolution solution(n, 5. / 3., 1., 1.);
    EXPECT_NEAR(solution.shock_speed() * 0.6, 0.2, 1e-15);

    const RadialState behind = solution.value(0.1999, 0.6);
    EXPECT_NEAR(behind.density, std::pow(4., n), 1e-11);
    EXPECT_EQ(behind.velocity, 0.);
    EXPECT_NEAR(behind.pressure, std::pow(4., n) / 3., 1e-11);

    const RadialState ahead = solution.value(0.2001, 0.6);
    EXPECT_NEAR(ahead.density, std::pow(1. + 0.6 / 0.2001, n - 1.), 1e-13);
    EXPECT_EQ(ahead.velocity, -1.);
  }
}

TEST(NohSolution, HoldsTheMassThatFlowedIn)
{
  for (unsigned int n = 1; n <= 3; ++n)
  {
    const NohSolution solution(n, 1.4, 2., 3.);
    const double time = 0.2, radius = 1.;
    const unsigned int shells = 100000;

    double mass = 0.;
    for (unsigned int i = 0; i < shells; ++i)
    {
      const double r = (i + 0.5) / shells * radius;
      mass += solution.value(r, time).density * std::pow(r, n - 1.);
    }
    mass *= radius / shells;
    // At time zero the same gas filled a larger ball of uniform density.
    EXPECT_NEAR(mass, 2. * std::pow(radius + 3. * time, n) / n, 1e-3 * mass);
  }
}

TEST(NohSolution, RefusesWhatHasNoSolution)
{
  EXPECT_THROW(NohSolution(0, 1.4, 1., 1.), InputError);
  EXPECT_THROW(NohSolution(3, 1., 1., 1.), InputError);
  EXPECT_THROW(NohSolution(3, 1.4, -1., 1.), InputError);
  EXPECT_THROW(NohSolution(3, 1.4, 1., 0.), InputError);
}

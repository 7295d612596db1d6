// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/colliding_disks.h>
#include <contrecoup/numerics/exact/dam_break.h>
#include <contrecoup/numerics/exact/spline_dispersion.h>
#include <contrecoup/numerics/exact/vibrating_bar.h>

#include <gtest/gtest.h>

using namespace contrecoup;

// The bar of many papers: period 10, centre of mass at up to 0.0637 m/s.
TEST(VibratingBar, has_the_published_period)
{
  const VibratingBar bar;
  EXPECT_NEAR(bar.period(), 10., 1e-12);
  EXPECT_NEAR(bar.frequency(), 0.6283, 5e-5);
  EXPECT_NEAR(bar.mean_velocity(0.), 0.0637, 5e-5);
  EXPECT_NEAR(bar.velocity(25., 5.), -0.1, 1e-15);
  EXPECT_EQ(bar.velocity(0., 3.), 0.);
}

// Of the third mode: rho u_tt = E u_xx, u_t = v, no stress at the free end, and
// the energy is what kinetic and stored energies add up to.
TEST(VibratingBar, obeys_the_wave_equation)
{
  VibratingBar bar;
  bar.mode = 3;
  bar.length = 2.;
  bar.density = 4.;
  const double h = 1e-4, x = 0.7, t = 0.13;
  const auto u = [&](const double place, const double time) {
    return bar.displacement(place, time);
  };
  const double in_time =
    (u(x, t + h) - 2. * u(x, t) + u(x, t - h)) * bar.density;
  const double in_space =
    (u(x + h, t) - 2. * u(x, t) + u(x - h, t)) * bar.young_modulus;
  EXPECT_NEAR(in_time / in_space, 1., 1e-5);
  EXPECT_NEAR((u(x, t + h) - u(x, t - h)) / (2. * h), bar.velocity(x, t), 1e-6);
  EXPECT_NEAR(u(2. + h, t) - u(2. - h, t), 0., 1e-12);
  double energy = 0., mean = 0.;
  const unsigned int n = 1000;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double place = (i + 0.5) * bar.length / n;
    const double v = bar.velocity(place, t);
    const double strain = (u(place + h, t) - u(place - h, t)) / (2. * h);
    energy += 0.5 *
              (bar.density * v * v + bar.young_modulus * strain * strain) *
              bar.length / n;
    mean += v / n;
  }
  EXPECT_NEAR(energy / bar.energy(), 1., 1e-6);
  EXPECT_NEAR(mean, bar.mean_velocity(t), 1e-6 * bar.speed);
}

// Two disks of Sulsky, Chen and Schreyer: 2.5133 J/m, contact at 1.586 s.
TEST(CollidingDisks, touch_when_published)
{
  const CollidingDisks disks;
  EXPECT_NEAR(disks.contact_time(), 1.586, 5e-4);
  EXPECT_NEAR(disks.kinetic_energy(), 2.5133, 5e-5);
  const dealii::Tensor<1, 2> apart =
    disks.second - disks.first -
    2. * disks.contact_time() * dealii::Tensor<1, 2>(disks.velocity_of_first);
  EXPECT_NEAR(apart.norm(), 2. * disks.radius, 1e-14);
}

TEST(CollidingDisks, may_miss_or_graze_each_other)
{
  CollidingDisks disks;
  disks.velocity_of_first = {0.1, -0.1};
  EXPECT_LT(disks.contact_time(), 0.);
  // Centres pass at a distance of 0.3 m.
  disks.first = {0., 0.};
  disks.second = {1., 0.3};
  disks.velocity_of_first = {0.1, 0.};
  EXPECT_NEAR(disks.contact_time(), (1. - std::sqrt(0.16 - 0.09)) / 0.2, 1e-14);
  disks.velocity_of_first = {-0.1, 0.};
  EXPECT_LT(disks.contact_time(), 0.);
}

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

TEST(DamBreak, fronts_run_ahead_and_agree_with_each_other)
{
  for (const auto *const points : {&martin_and_moyce_front(),
                                   &martin_and_moyce_small_front(),
                                   &koshizuka_and_oka_front()})
    for (std::size_t i = 1; i < points->size(); ++i)
    {
      EXPECT_GT((*points)[i].time, (*points)[i - 1].time);
      EXPECT_GT((*points)[i].front, (*points)[i - 1].front);
      // No faster than a front without friction, 2 sqrt(g 2 a).
      EXPECT_LT(((*points)[i].front - (*points)[i - 1].front) /
                  ((*points)[i].time - (*points)[i - 1].time),
                2.);
    }
  for (double time = 0.9; time < 3.; time += 0.1)
  {
    const double front = dam_break_front(martin_and_moyce_front(), time);
    EXPECT_NEAR(
      dam_break_front(martin_and_moyce_small_front(), time) / front, 1., 0.05);
    EXPECT_NEAR(
      dam_break_front(koshizuka_and_oka_front(), time) / front, 1., 0.14);
  }
  EXPECT_EQ(dam_break_front(koshizuka_and_oka_front(), 9.), 3.624);
  EXPECT_NEAR(dam_break_front(martin_and_moyce_front(), 1.31), 1.555, 1e-12);
}

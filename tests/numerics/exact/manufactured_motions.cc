// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/axis_aligned_motion.h>
#include <contrecoup/numerics/exact/generalized_vortex.h>

#include <gtest/gtest.h>

#include <functional>

using namespace contrecoup;

namespace
{
using dealii::Point;
using dealii::Tensor;
using Map = std::function<Point<2>(const Point<2> &, double)>;

/// A step of one of two coordinates.
Point<2> shifted(const Point<2> &x, const unsigned int d, const double by)
{
  Point<2> result = x;
  result[d] += by;
  return result;
}

/// Central differences of the fourth order.
template <typename Value>
Value slope(const std::function<Value(double)> &f, const double h)
{
  return (8. * (f(h) - f(-h)) - (f(2. * h) - f(-2. * h))) / (12. * h);
}

Tensor<2, 2> gradient_of(const Map &map, const Point<2> &x, const double time)
{
  Tensor<2, 2> result;
  for (unsigned int d = 0; d < 2; ++d)
  {
    const Tensor<1, 2> column = slope<Tensor<1, 2>>(
      [&](const double h) { return Tensor<1, 2>(map(shifted(x, d, h), time)); },
      1e-3);
    for (unsigned int i = 0; i < 2; ++i)
      result[i][d] = column[i];
  }
  return result;
}

/// The Piola stress by differences of the stored energy, in plane strain.
Tensor<2, 2> stress_of(const NeoHookean &solid, const Tensor<2, 2> &f)
{
  Tensor<2, 2> result;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      result[i][j] = slope<double>(
        [&](const double h) {
          Tensor<2, 2> g = f;
          g[i][j] += h;
          return solid.energy(g.norm_square() + 1., determinant(g));
        },
        1e-3);
  return result;
}

/// The body force that a motion needs, all by differences.
Tensor<1, 2> needed_force(const NeoHookean &solid,
                          const Map &map,
                          const Point<2> &x,
                          const double time,
                          const double time_step)
{
  const auto velocity = [&](const double t) {
    return slope<Tensor<1, 2>>(
      [&](const double h) { return Tensor<1, 2>(map(x, t + h)); }, time_step);
  };
  Tensor<1, 2> result = slope<Tensor<1, 2>>(
    [&](const double h) { return velocity(time + h); }, time_step);
  for (unsigned int d = 0; d < 2; ++d)
  {
    const Tensor<2, 2> change = slope<Tensor<2, 2>>(
      [&](const double h) {
        return stress_of(solid, gradient_of(map, shifted(x, d, h), time));
      },
      1e-3);
    for (unsigned int i = 0; i < 2; ++i)
      result[i] -= change[i][d] / solid.density;
  }
  return result;
}

/// Checks velocities, gradients and body forces at some places and times.
template <typename Motion>
void check(const Motion &motion,
           const std::vector<Point<2>> &places,
           const std::vector<double> &times,
           const double time_step,
           const double largest_force)
{
  const Map map = [&](const Point<2> &x, const double t) {
    return motion.position(x, t);
  };
  for (const Point<2> &x : places)
    for (const double t : times)
    {
      const Tensor<1, 2> velocity = slope<Tensor<1, 2>>(
        [&](const double h) { return Tensor<1, 2>(map(x, t + h)); }, time_step);
      EXPECT_LT((velocity - motion.velocity(x, t)).norm(),
                1e-7 * (1. + velocity.norm()))
        << x << " at " << t;
      const Tensor<1, 2> force =
        needed_force(motion.solid, map, x, t, time_step);
      EXPECT_LT((force - motion.body_force(x, t)).norm(), 2e-6 * largest_force)
        << x << " at " << t << ": " << force << " and "
        << motion.body_force(x, t);
    }
}
} // namespace

TEST(GeneralizedVortex, balances_momentum_with_both_neo_hookean_solids)
{
  for (const auto form : {NeoHookeanForm::split, NeoHookeanForm::coupled})
  {
    GeneralizedVortex vortex;
    vortex.solid.form = form;
    check(vortex,
          {{0.9, 0.1}, {-0.3, 1.}, {0.5, -1.05}, {-0.75, -0.3}},
          {0.2, 0.5, 0.83},
          1e-3,
          50.);
  }
}

TEST(GeneralizedVortex, keeps_volumes_and_its_edges)
{
  const GeneralizedVortex vortex;
  const Map map = [&](const Point<2> &x, const double t) {
    return vortex.position(x, t);
  };
  for (const Point<2> &x : {Point<2>(0.9, 0.2), Point<2>(-0.4, 0.95)})
  {
    const Tensor<2, 2> f = vortex.gradient(x, 0.4);
    EXPECT_NEAR(determinant(f), 1., 1e-14);
    EXPECT_LT((f - gradient_of(map, x, 0.4)).norm(), 1e-7);
  }
  // A radian in the middle of the ring at half of the time.
  EXPECT_NEAR(vortex.position({1., 0.}, 0.5)[1], std::sin(1.), 1e-14);
  for (const double radius : {0.75, 1.25})
  {
    EXPECT_EQ(vortex.position({radius, 0.}, 0.5)[0], radius);
    EXPECT_EQ(vortex.velocity({radius, 0.}, 0.3).norm(), 0.);
  }
  EXPECT_NEAR(vortex.position({1., 0.}, 1.)[0], 1., 1e-14);
}

TEST(AxisAlignedMotion, balances_momentum_with_both_neo_hookean_solids)
{
  for (const auto form : {NeoHookeanForm::split, NeoHookeanForm::coupled})
  {
    AxisAlignedMotion motion;
    motion.solid.form = form;
    check(motion,
          {{0.3, 0.4}, {0.85, 0.1}, {0.2, 0.9}},
          {2e-3, 5e-3, 1.3e-2},
          1e-5,
          5e3);
  }
}

// The papers' solid: without stretch along y the force is
// pi^2 u (mu (1 + 1/a^2) + lambda (1 - ln a) / a^2 - E), E = rho c^2.
TEST(AxisAlignedMotion, has_the_published_force)
{
  AxisAlignedMotion motion;
  motion.solid.form = NeoHookeanForm::coupled;
  const double time = 5e-3, u = 0.05 * std::sin(0.3 * M_PI);
  const double a = 1. + 0.05 * M_PI * std::cos(0.3 * M_PI);
  const double mu = 3846.1538, lambda = 5769.2307;
  EXPECT_NEAR(motion.stretches({0.3, 0.5}, time)[0], a, 1e-14);
  EXPECT_NEAR(motion.stretches({0.3, 0.5}, time)[1], 1., 1e-14);
  EXPECT_NEAR(
    motion.body_force({0.3, 0.5}, time)[0],
    M_PI * M_PI * u *
      (mu * (1. + 1. / (a * a)) + lambda * (1. - std::log(a)) / (a * a) - 1e4),
    1e-3);
  EXPECT_EQ(motion.position({0., 1.}, time)[0], 0.);
}

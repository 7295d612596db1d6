// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/rigid_sphere_solution.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
namespace
{
  using dealii::numbers::PI;

  /// Spherical Bessel function j_1; faster than the library's.
  double bessel(const double x)
  {
    if (x < 1e-3)
      return x / 3.;
    return (std::sin(x) / x - std::cos(x)) / x;
  }

  /// Derivative of j_1.
  double bessel_slope(const double x)
  {
    return std::sin(x) / x - 2. / x * bessel(x);
  }
} // namespace


RigidSphereSolution::RigidSphereSolution(const RigidSphere &sphere,
                                         const unsigned int n_modes)
  : sphere_(sphere)
{
  for (unsigned int n = 1; n <= n_modes; ++n)
  {
    double low = (n - 0.5) * PI, high = n * PI;
    for (unsigned int i = 0; i < 60; ++i)
    {
      const double middle = 0.5 * (low + high);
      (bessel_slope(low) * bessel_slope(middle) <= 0. ? high : low) = middle;
    }
    roots_.push_back(0.5 * (low + high));
  }
}


double RigidSphereSolution::response(const double root, const double time) const
{
  // sin(o s) sin(w (t - s)) = [cos(o s - w (t - s)) - cos(o s + w (t - s))] /
  // 2, with the frequencies o of the deceleration and w of the mode.
  const double w = root * sphere_.sound_speed / sphere_.radius;
  const double o = PI / sphere_.duration;
  const double end = std::min(time, sphere_.duration);
  const double sum =
    (std::sin((o + w) * end - w * time) + std::sin(w * time)) / (o + w);
  const double difference = o - w;
  const double other =
    std::abs(difference) > 1e-9 * w
      ? (std::sin(difference * end + w * time) - std::sin(w * time)) /
          difference
      : end * std::cos(w * time);
  return 0.5 * (sum - other);
}


double RigidSphereSolution::pressure(const double distance,
                                     const double cosine,
                                     const double time) const
{
  double sum = 0.;
  for (const double a : roots_)
    sum += 2. * a / (a * a - 2.) * bessel(a * distance / sphere_.radius) /
           bessel(a) * response(a, time);
  return sphere_.density * sphere_.sound_speed * sphere_.deceleration * cosine *
         sum;
}
} // namespace contrecoup

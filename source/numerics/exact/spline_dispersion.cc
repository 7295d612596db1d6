// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/spline_dispersion.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <cmath>

namespace contrecoup
{
namespace
{
  /// Centred cardinal B-spline, by the Cox-de Boor recursion.
  double spline(const unsigned int degree, const double x)
  {
    if (degree == 0)
      return x >= -0.5 && x < 0.5 ? 1. : 0.;
    const double half = 0.5 * (degree + 1);
    return ((half + x) * spline(degree - 1, x + 0.5) +
            (half - x) * spline(degree - 1, x - 0.5)) /
           degree;
  }
} // namespace


SplineDispersion::SplineDispersion(const unsigned int degree)
  : degree_(degree)
{
  Assert(degree > 0, dealii::ExcMessage("splines need a slope"));
}


double SplineDispersion::mass(const double phase) const
{
  const unsigned int n = 2 * degree_ + 1;
  double sum = spline(n, 0.);
  for (unsigned int j = 1; j <= degree_; ++j)
    sum += 2. * spline(n, j) * std::cos(j * phase);
  return sum;
}


double SplineDispersion::stiffness(const double phase) const
{
  // The second derivative of a spline is the second difference of the spline
  // of two degrees less, a factor in its symbol.
  const unsigned int n = 2 * degree_ - 1;
  double sum = spline(n, 0.);
  for (unsigned int j = 1; j < degree_; ++j)
    sum += 2. * spline(n, j) * std::cos(j * phase);
  return (2. - 2. * std::cos(phase)) * sum;
}


double SplineDispersion::speed(const double cells,
                               const unsigned int terms) const
{
  const double phase = 2. * dealii::numbers::PI / cells;
  const double m = mass(phase);
  double series = 0.;
  for (unsigned int i = 0; i < terms; ++i)
    series = 1. + (1. - m) * series;
  return std::sqrt(stiffness(phase) * m) * series / phase;
}


double SplineDispersion::consistent_speed(const double cells) const
{
  const double phase = 2. * dealii::numbers::PI / cells;
  return std::sqrt(stiffness(phase) / mass(phase)) / phase;
}
} // namespace contrecoup

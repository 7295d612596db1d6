// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/study/convergence.h>

#include <cmath>
#include <limits>

namespace contrecoup::study
{
namespace
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double lowest_order = 0.05, highest_order = 20.;

  /// (a^p - b^p) / (b^p - c^p) for widths a > b > c; increases with p.
  double ratio(const double a, const double b, const double c, const double p)
  {
    return (std::pow(a / b, p) - 1.) / (1. - std::pow(c / b, p));
  }

  /// Order for which ratio() equals @p required_ratio, by bisection.
  double order_of(const double a,
                  const double b,
                  const double c,
                  const double required_ratio)
  {
    double low = lowest_order, high = highest_order;
    if (!(ratio(a, b, c, low) < required_ratio &&
          required_ratio < ratio(a, b, c, high)))
      return nan;
    for (int i = 0; i < 100; ++i)
    {
      const double middle = 0.5 * (low + high);
      (ratio(a, b, c, middle) < required_ratio ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
} // namespace

double observed_order(const double coarse_error,
                      const double fine_error,
                      const double coarse_width,
                      const double fine_width)
{
  if (!(coarse_error > 0. && fine_error > 0. && coarse_width > 0. &&
        fine_width > 0.) ||
      coarse_width == fine_width)
    return nan;
  return std::log(coarse_error / fine_error) /
         std::log(coarse_width / fine_width);
}

Extrapolation extrapolate(const std::vector<double> &widths,
                          const std::vector<double> &values)
{
  const std::size_t n = values.size();
  if (n < 3 || widths.size() != n)
    throw InputError("an extrapolation needs the results on at least three "
                     "meshes");
  Extrapolation result;
  result.limit = values[n - 1];
  const double b = widths[n - 2], c = widths[n - 1];
  const double before = values[n - 3] - values[n - 2];
  const double last = values[n - 2] - values[n - 1];
  result.order =
    last == 0. ? nan : order_of(widths[n - 3], b, c, before / last);
  result.is_asymptotic = !std::isnan(result.order);
  if (result.is_asymptotic)
    result.limit -= last / (std::pow(b / c, result.order) - 1.);
  return result;
}
} // namespace contrecoup::study

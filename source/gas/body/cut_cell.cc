// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/cut_cell.h>

#include <algorithm>

namespace contrecoup::gas
{
namespace
{
  /// Relative distance [-] from the corner with the positive value to the zero
  /// of the function on the edge to another corner.
  double zero_crossing(const double positive, const double other)
  {
    return positive / (positive - other);
  }


  /// Fraction of a simplex of n corners where a linear function is positive.
  template <std::size_t n>
  double simplex_fraction(std::array<double, n> v)
  {
    std::sort(
      v.begin(), v.end(), [](const double a, const double b) { return a > b; });
    const auto n_positive =
      std::count_if(v.begin(), v.end(), [](const double x) { return x > 0.; });
    if (n_positive == 0)
      return 0.;
    if (n_positive == n)
      return 1.;
    double corner = 1.;
    if (n_positive == 1)
    {
      for (std::size_t i = 1; i < n; ++i)
        corner *= zero_crossing(v[0], v[i]);
      return corner;
    }
    if (n_positive == n - 1)
    {
      for (std::size_t i = 0; i + 1 < n; ++i)
        corner *= zero_crossing(-v[n - 1], -v[i]);
      return 1. - corner;
    }
    // Two corners of a tetrahedron: a wedge of three tetrahedra.
    const double ac = zero_crossing(v[0], v[2]);
    const double ad = zero_crossing(v[0], v[n - 1]);
    const double bc = zero_crossing(v[1], v[2]);
    const double bd = zero_crossing(v[1], v[n - 1]);
    return bc * bd + ac * (1. - bc) * bd + ac * ad * (1. - bd);
  }
} // namespace


template <>
double positive_fraction<2>(const std::array<double, 2> &corners)
{
  return simplex_fraction(corners);
}


template <>
double positive_fraction<4>(const std::array<double, 4> &v)
{
  return 0.5 * (simplex_fraction<3>({{v[0], v[1], v[3]}}) +
                simplex_fraction<3>({{v[0], v[2], v[3]}}));
}


template <>
double positive_fraction<8>(const std::array<double, 8> &v)
{
  if (std::all_of(v.begin(), v.end(), [](const double x) { return x > 0.; }))
    return 1.;
  double sum = 0.;
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b < 3; ++b)
      if (a != b)
        sum += simplex_fraction<4>(
          {{v[0], v[1U << a], v[(1U << a) + (1U << b)], v[7]}});
  return sum / 6.;
}
} // namespace contrecoup::gas

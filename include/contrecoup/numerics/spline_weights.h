// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>
#include <cmath>

namespace contrecoup
{
/// Values and slopes of the B-splines that do not vanish at a place, along one
/// direction of a uniform grid.
struct SplineWeights
{
  /// Of the spline whose weight is the first one: its node.
  int first;
  /// Padded with zeros to four.
  std::array<double, 4> value;
  /// Per grid cell.
  std::array<double, 4> slope;
};

/**
 * B-splines of degree 1, 2 or 3 with their centres at the nodes of a uniform
 * grid: they are positive, sum up to 1 and reproduce linear functions. Steffen,
 * Kirby and Berzins, Int. J. Numer. Methods Eng. 76 (2008), section 3.
 * @param place over the cell size; node i is at i
 */
template <unsigned int degree>
inline SplineWeights spline_weights(const double place)
{
  static_assert(degree >= 1 && degree <= 3, "linear, quadratic or cubic");
  SplineWeights w;
  if constexpr (degree == 1)
  {
    const double left = std::floor(place), f = place - left;
    w.first = static_cast<int>(left);
    w.value = {{1. - f, f, 0., 0.}};
    w.slope = {{-1., 1., 0., 0.}};
  }
  else if constexpr (degree == 2)
  {
    const double nearest = std::floor(place + 0.5), f = place - nearest;
    w.first = static_cast<int>(nearest) - 1;
    w.value = {{0.5 * (0.5 - f) * (0.5 - f),
                0.75 - f * f,
                0.5 * (0.5 + f) * (0.5 + f),
                0.}};
    w.slope = {{f - 0.5, -2. * f, f + 0.5, 0.}};
  }
  else
  {
    const double left = std::floor(place), f = place - left, g = 1. - f;
    w.first = static_cast<int>(left) - 1;
    w.value = {{g * g * g / 6.,
                2. / 3. - f * f * (1. - 0.5 * f),
                2. / 3. - g * g * (1. - 0.5 * g),
                f * f * f / 6.}};
    w.slope = {
      {-0.5 * g * g, f * (1.5 * f - 2.), g * (2. - 1.5 * g), 0.5 * f * f}};
  }
  return w;
}

/// Sum of N_i (x_i - x)^2 over the nodes of one direction, in squared cells:
/// 1/4 of quadratic, 1/3 of cubic splines; affine transfers divide by it.
/// Linear splines have no constant one. Jiang and others, SIGGRAPH 2015.
constexpr double spline_inertia(const unsigned int degree)
{
  return degree == 2 ? 0.25 : 1. / 3.;
}
} // namespace contrecoup

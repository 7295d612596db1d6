// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>
#include <cmath>

namespace contrecoup
{
/// Values and slopes of the nonzero B-splines at a point, along one direction
/// of a uniform grid.
template <typename Number>
struct SplineWeightsOf
{
  /// Node of the first spline.
  int first;
  /// Values, padded with zeros to four.
  std::array<Number, 4> value;
  /// Slopes per grid cell.
  std::array<Number, 4> slope;
};
using SplineWeights = SplineWeightsOf<double>;

/// spline_shift() is added to position / cell size before rounding down;
/// first_node_offset() is the number of nodes from the first spline to the
/// result.
constexpr double spline_shift(const unsigned int degree)
{
  return degree == 2 ? 0.5 : 0.;
}
constexpr int first_node_offset(const unsigned int degree)
{
  return degree == 1 ? 0 : 1;
}

/**
 * B-splines of degree 1, 2 or 3, centred at the nodes of a uniform grid:
 * positive, partition of unity, linear reproduction (Steffen, Kirby and
 * Berzins, Int. J. Numer. Methods Eng. 76 (2008), section 3).
 * @param f position over cell size, minus the rounded one
 * @return weights; `first` is not set
 */
template <unsigned int degree, typename Number>
inline SplineWeightsOf<Number> spline_weights_at(const Number &f)
{
  static_assert(degree >= 1 && degree <= 3, "linear, quadratic or cubic");
  SplineWeightsOf<Number> w;
  const Number zero(0.), one(1.), half(0.5);
  if constexpr (degree == 1)
  {
    w.value = {{one - f, f, zero, zero}};
    w.slope = {{-one, one, zero, zero}};
  }
  else if constexpr (degree == 2)
  {
    const Number left = half - f, right = half + f;
    w.value = {
      {half * left * left, Number(0.75) - f * f, half * right * right, zero}};
    w.slope = {{-left, -(f + f), right, zero}};
  }
  else
  {
    const Number g = one - f, f2 = f * f, g2 = g * g;
    w.value = {{g2 * g * (1. / 6.),
                Number(2. / 3.) - f2 * (one - half * f),
                Number(2. / 3.) - g2 * (one - half * g),
                f2 * f * (1. / 6.)}};
    w.slope = {{-half * g2,
                f * (f * 1.5 - Number(2.)),
                g * (Number(2.) - g * 1.5),
                half * f2}};
  }
  return w;
}

/// The same at a position. @param place over the cell size; node i is at i
template <unsigned int degree>
inline SplineWeights spline_weights(const double place)
{
  const double node = std::floor(place + spline_shift(degree));
  SplineWeights w = spline_weights_at<degree>(place - node);
  w.first = static_cast<int>(node) - first_node_offset(degree);
  return w;
}

/// Sum of N_i (x_i - x)^2 over the nodes of one direction, in squared cells:
/// 1/4 for quadratic, 1/3 for cubic splines; affine transfers divide by this
/// value. It is not constant for linear splines. Jiang and others, SIGGRAPH
/// 2015.
constexpr double spline_inertia(const unsigned int degree)
{
  return degree == 2 ? 0.25 : 1. / 3.;
}
} // namespace contrecoup

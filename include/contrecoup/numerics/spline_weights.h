// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>
#include <cmath>

namespace contrecoup
{
/// Values and slopes of the B-splines that do not vanish at a place, along one
/// direction of a uniform grid.
template <typename Number>
struct SplineWeightsOf
{
  /// Of the spline whose weight is the first one: its node.
  int first;
  /// Padded with zeros to four.
  std::array<Number, 4> value;
  /// Per grid cell.
  std::array<Number, 4> slope;
};
using SplineWeights = SplineWeightsOf<double>;

/// What is added to a place over the cell size before it is rounded down, and
/// how many nodes before that the first spline sits.
constexpr double spline_shift(const unsigned int degree)
{
  return degree == 2 ? 0.5 : 0.;
}
constexpr int spline_lead(const unsigned int degree)
{
  return degree == 1 ? 0 : 1;
}

/**
 * B-splines of degree 1, 2 or 3 with their centres at the nodes of a uniform
 * grid: they are positive, sum up to 1 and reproduce linear functions. Steffen,
 * Kirby and Berzins, Int. J. Numer. Methods Eng. 76 (2008), section 3.
 * @param f place over the cell size, less the rounded one
 * @return first is left alone
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

/// The same of a place. @param place over the cell size; node i is at i
template <unsigned int degree>
inline SplineWeights spline_weights(const double place)
{
  const double node = std::floor(place + spline_shift(degree));
  SplineWeights w = spline_weights_at<degree>(place - node);
  w.first = static_cast<int>(node) - spline_lead(degree);
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

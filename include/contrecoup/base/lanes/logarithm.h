// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>

#include <array>
#include <cmath>

namespace contrecoup
{
/// log(x) of a scalar.
inline double logarithm(const double x)
{
  return std::log(x);
}

/**
 * log(x) in every lane, to about two units in the last place: 2 atanh(z), z =
 * (x - 1) / (x + 1), with a short series if all lanes are in [0.7, 1.43];
 * otherwise the library function, lane by lane.
 */
template <std::size_t width>
inline DEAL_II_ALWAYS_INLINE LaneGroup<double, width>
logarithm(const LaneGroup<double, width> &x)
{
  using Group = LaneGroup<double, width>;
  const Group low(0.7), high(1.43);
  if (any_less(x, low) || any_less(high, x))
  {
    Group result;
    for (unsigned int lane = 0; lane < width; ++lane)
      result[lane] = std::log(x[lane]);
    return result;
  }
  const Group z = (x - 1.) / (x + 1.);
  const Group square = z * z;
  constexpr unsigned int n_terms = 11;
  Group sum(2. / (2. * n_terms + 1.));
  for (unsigned int k = n_terms; k > 0; --k)
    sum = sum * square + Group(2. / (2. * k - 1.));
  return sum * z;
}
} // namespace contrecoup

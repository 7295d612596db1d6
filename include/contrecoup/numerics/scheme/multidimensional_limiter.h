// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/base/system/names.h>

#include <array>
#include <limits>

namespace contrecoup
{
/// Gradient limiters for meshes of any shape.
enum class GradientLimiter
{
  barth_jespersen, ///< Barth and Jespersen 1989
  venkatakrishnan  ///< 1993
};

/// All gradient limiters, for entry and help text.
inline constexpr std::array<NamedChoice<GradientLimiter>, 2> gradient_limiters{
  {{GradientLimiter::barth_jespersen,
    "barth jespersen",
    "allows no new extremum at any face"},
   {GradientLimiter::venkatakrishnan,
    "venkatakrishnan",
    "is smooth and limits less near plateaus"}}};

/**
 * Factor in [0, 1] on a cell's gradient that one of its faces requires; the
 * minimum over all faces applies.
 *
 * @param room_below minimum over the cell and its neighbours, minus the cell's
 * value; not positive
 * @param room_above maximum over the cell and its neighbours, minus the cell's
 * value; not negative
 * @param increment unlimited change from cell centre to face centre
 * @param plateau square of a change too small to be limited (for
 * Venkatakrishnan, (K h)^3 in units of the value squared); not negative
 */
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number
gradient_limiter_factor(const GradientLimiter limiter,
                        const Number &room_below,
                        const Number &room_above,
                        const Number &increment,
                        const Number &plateau)
{
  const Number zero(0.), one(1.), tiny(std::numeric_limits<float>::min());
  // Room and change along the increment, both positive.
  const Number allowed_change =
    select_less(increment, zero, Number(-room_below), room_above);
  const Number change = std::abs(increment);
  if (limiter == GradientLimiter::barth_jespersen)
    return std::min(allowed_change, change) / std::max(change, tiny) +
           select_less(change, tiny, one, zero);

  const Number common = allowed_change * allowed_change + plateau;
  return std::min(
    one,
    Number((common + change * allowed_change * 2. + tiny) /
           (common + change * (change * 2. + allowed_change) + tiny)));
}
} // namespace contrecoup

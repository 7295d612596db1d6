// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/point.h>

#include <optional>

namespace contrecoup::gas
{
/// Axis-aligned box, which may be flat [m].
template <int dim>
struct Box
{
  dealii::Point<dim> lower, upper;

  dealii::Point<dim> center() const
  {
    return dealii::Point<dim>((lower + upper) * 0.5);
  }
  double radius() const
  {
    return 0.5 * lower.distance(upper);
  }
};


/// Result of a search: a position; that there is none; or, with neither, that
/// the search was inconclusive.
template <int dim>
struct Finding
{
  std::optional<dealii::Point<dim>> place;
  bool is_nowhere = true;
};


/// Searches a box for a position where @p function, which is Lipschitz
/// continuous with constant 1, is below @p bound. Boxes whose centre value
/// excludes such a position are dropped, others are bisected in all
/// directions until their radius is below @p tolerance.
template <int dim, typename Function>
Finding<dim> find_below(const Box<dim> &box,
                        const double bound,
                        const double tolerance,
                        const Function &function)
{
  const dealii::Point<dim> middle = box.center();
  const double value = function(middle), radius = box.radius();
  if (value < bound)
    return {middle, false};
  if (value - radius >= bound)
    return {};
  Finding<dim> result;
  result.is_nowhere = radius > tolerance;
  for (unsigned int c = 0; c < (1U << dim) && radius > tolerance; ++c)
  {
    Box<dim> half = box;
    bool is_twin = false; // of a box that is flat in a direction
    for (unsigned int d = 0; d < dim; ++d)
      is_twin =
        is_twin || (((c >> d) & 1U) != 0 && box.lower[d] == box.upper[d]);
    if (is_twin)
      continue;
    for (unsigned int d = 0; d < dim; ++d)
      ((c >> d) & 1U ? half.lower : half.upper)[d] = middle[d];
    const Finding<dim> found = find_below(half, bound, tolerance, function);
    if (found.place)
      return found;
    result.is_nowhere = result.is_nowhere && found.is_nowhere;
  }
  return result;
}
} // namespace contrecoup::gas

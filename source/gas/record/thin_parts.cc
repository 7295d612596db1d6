// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/thin_parts.h>

#include <algorithm>

namespace contrecoup::gas
{
using dealii::Point;

namespace
{
  /// Depth of the body below a point of its surface, at most @p largest [m].
  double depth_below(const Point<3> &point,
                     const RigidBody &body,
                     const double largest)
  {
    const dealii::Tensor<1, 3> inwards = -1. * body.normal(point);
    const double smallest_step = 0.02 * largest;
    double depth = smallest_step;
    while (depth < largest)
    {
      const double value = body.value(Point<3>(point + depth * inwards));
      if (value >= 0.)
        return depth;
      depth += std::max(-value, smallest_step);
    }
    return largest;
  }
} // namespace


std::string warn_of_thin_parts(const RigidBody &body,
                               const std::vector<Landmark> &places,
                               const double diagonal)
{
  std::vector<std::string> thin;
  for (const Landmark &place : places)
    if (depth_below(place.place, body, diagonal) < diagonal)
      thin.push_back(place.name);
  return thin.empty()
           ? ""
           : "WARNING: parts of the body may be missing in the gas: at " +
               join(thin, ", ") +
               " the body is thinner than the diagonal of a cell, " +
               brief(1e3 * diagonal, 3) + " mm";
}
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/thin_parts.h>

#include <algorithm>
#include <map>

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


std::vector<std::string> warn_of_patches(const std::vector<GaugePatch> &patches,
                                         const double diagonal)
{
  std::vector<std::string> lost, warnings, shared;
  std::map<std::vector<std::size_t>, std::vector<std::string>> names;
  for (const GaugePatch &patch : patches)
  {
    names[patch.facets].push_back(patch.name);
    if (patch.distance > diagonal)
      lost.push_back(patch.name);
  }
  if (!lost.empty())
    warnings.push_back(
      "WARNING: the gas has no skin at " + join(lost, ", ") +
      ": the nearest is beyond the diagonal of a cell, " +
      brief(1e3 * diagonal, 3) +
      " mm, and what gauges read there is of other parts of the body");
  for (const auto &[facets, same] : names)
    if (same.size() > 1)
      shared.push_back(join(same, " and "));
  if (!shared.empty())
    warnings.push_back("WARNING: gauges have the same loads, since they fell "
                       "on the same facets: " +
                       join(shared, "; "));
  return warnings;
}
} // namespace contrecoup::gas

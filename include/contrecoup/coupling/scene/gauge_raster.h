// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <map>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// Where a user asks for the wave in the air: one probe, a line or a plane of
/// probes. Their spacing is left out.
struct GaugeRaster
{
  dealii::Point<3> begin, end; ///< opposite corners [m]
  std::string entry = {};      ///< of blast, as "Probes/Points"
  bool is_line = false;        ///< the straight line between the corners

  /// The same as a box, without an extent where both corners agree [m].
  dealii::BoundingBox<3> box() const;

  /// Its place that is nearest to @p place [m].
  dealii::Point<3> nearest(const dealii::Point<3> &place) const;

  /// Places in it that are at most @p spacing apart along each direction [m].
  std::vector<dealii::Point<3>> places(double spacing) const;
};

/// Place in the box that is nearest to @p place.
dealii::Point<3> nearest_place(const dealii::BoundingBox<3> &box,
                               const dealii::Point<3> &place);

/// Distance from @p place to the farthest corner of the box [m].
double farthest_distance(const dealii::BoundingBox<3> &box,
                         const dealii::Point<3> &place);

/// Those of the entries Probes/Points, Lines and Gauge planes of blast; what
/// blast refuses is left out.
/// @param values by path of the entry
std::vector<GaugeRaster>
find_gauges(const std::map<std::string, std::string> &values);
} // namespace contrecoup::coupling

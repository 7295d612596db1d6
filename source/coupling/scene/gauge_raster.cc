// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/scene/gauge_raster.h>
#include <contrecoup/coupling/scene/own_grid.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace contrecoup::coupling
{
using dealii::Point;

dealii::BoundingBox<3> GaugeRaster::box() const
{
  std::pair<Point<3>, Point<3>> corners{begin, end};
  for (unsigned int d = 0; d < 3; ++d)
  {
    corners.first[d] = std::min(begin[d], end[d]);
    corners.second[d] = std::max(begin[d], end[d]);
  }
  return corners;
}


Point<3> GaugeRaster::nearest(const Point<3> &place) const
{
  Point<3> found;
  if (is_line)
  {
    const auto way = end - begin;
    const double part = (place - begin) * way / way.norm_square();
    found = begin + std::clamp(part, 0., 1.) * way;
  }
  else
    for (unsigned int d = 0; d < 3; ++d)
      found[d] = std::clamp(
        place[d], std::min(begin[d], end[d]), std::max(begin[d], end[d]));
  return found;
}


std::vector<Point<3>> GaugeRaster::places(const double spacing) const
{
  const auto way = end - begin;
  const auto count = [&](const double length) {
    return std::max(1U, static_cast<unsigned int>(std::ceil(length / spacing)));
  };
  std::array<unsigned int, 3> counts{{1, 1, 1}};
  for (unsigned int d = 0; d < 3 && !is_line; ++d)
    counts[d] = count(std::abs(way[d]));
  if (is_line)
    counts[0] = count(way.norm());
  std::vector<Point<3>> places;
  for (unsigned int k = 0; k < counts[2]; ++k)
    for (unsigned int j = 0; j < counts[1]; ++j)
      for (unsigned int i = 0; i < counts[0]; ++i)
      {
        const std::array<double, 3> part{{(i + 0.5) / counts[0],
                                          (j + 0.5) / counts[1],
                                          (k + 0.5) / counts[2]}};
        Point<3> place = begin;
        for (unsigned int d = 0; d < 3; ++d)
          place[d] += part[is_line ? 0 : d] * way[d];
        places.push_back(place);
      }
  return places;
}


Point<3> nearest_place(const dealii::BoundingBox<3> &box, const Point<3> &place)
{
  Point<3> nearest;
  for (unsigned int d = 0; d < 3; ++d)
    nearest[d] = std::clamp(place[d], box.lower_bound(d), box.upper_bound(d));
  return nearest;
}


double farthest_distance(const dealii::BoundingBox<3> &box,
                         const Point<3> &place)
{
  double squares = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    squares += std::pow(std::max(std::abs(box.lower_bound(d) - place[d]),
                                 std::abs(box.upper_bound(d) - place[d])),
                        2);
  return std::sqrt(squares);
}


std::vector<GaugeRaster>
find_gauges(const std::map<std::string, std::string> &values)
{
  std::vector<GaugeRaster> gauges;
  for (const std::string &part : split(values.at("Probes/Points"), ';'))
    if (const auto point = point_of(part))
      gauges.push_back({*point, *point, "Probes/Points"});
  for (const bool is_line : {true, false})
  {
    const std::string entry = is_line ? "Probes/Lines" : "Probes/Gauge planes";
    for (const std::string &item : split(values.at(entry), ';'))
    {
      const std::vector<std::string> parts = split(item, ':');
      const auto begin = point_of(parts.front());
      const auto end = parts.size() == 3 ? point_of(parts[1]) : std::nullopt;
      if (begin && end && begin->distance(*end) > 0.)
        gauges.push_back({*begin, *end, entry, is_line});
    }
  }
  return gauges;
}
} // namespace contrecoup::coupling

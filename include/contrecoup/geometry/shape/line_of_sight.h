// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/point.h>

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace contrecoup
{
/// Tells whether triangles stand between two places.
class LineOfSight
{
public:
  using Triangle = std::array<dealii::Point<3>, 3>;

  explicit LineOfSight(std::vector<Triangle> triangles);

  /// Whether a triangle meets the segment between two places [m].
  bool is_blocked(const dealii::Point<3> &from,
                  const dealii::Point<3> &to) const;

private:
  using Corner =
    boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Box = boost::geometry::model::box<Corner>;
  using Entry = std::pair<Box, std::uint32_t>;

  std::vector<Triangle> triangles_;
  boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16>> tree_;
};
} // namespace contrecoup

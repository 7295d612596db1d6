// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/line_of_sight.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  namespace bg = boost::geometry;

  /// Whether a segment meets a triangle (T. Moeller and B. Trumbore, J.
  /// Graphics Tools 2, 1997, 21-28); not if it lies in the triangle's plane.
  bool meets(const Point<3> &from,
             const Tensor<1, 3> &way,
             const LineOfSight::Triangle &triangle)
  {
    const Tensor<1, 3> a = triangle[1] - triangle[0];
    const Tensor<1, 3> b = triangle[2] - triangle[0];
    const Tensor<1, 3> across = cross_product_3d(way, b);
    const double volume = a * across;
    if (volume == 0.)
      return false;
    const Tensor<1, 3> start = from - triangle[0];
    const double u = (start * across) / volume;
    const Tensor<1, 3> other = cross_product_3d(start, a);
    const double v = (way * other) / volume;
    const double t = (b * other) / volume;
    return u >= 0. && v >= 0. && u + v <= 1. && t >= 0. && t <= 1.;
  }
} // namespace


struct LineOfSight::Search
{
  using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
  using Box = bg::model::box<Corner>;
  using Entry = std::pair<Box, std::uint32_t>;

  bg::index::rtree<Entry, bg::index::rstar<16>> tree;
};


LineOfSight::LineOfSight(std::vector<Triangle> triangles)
  : triangles_(std::move(triangles))
{
  using Corner = Search::Corner;
  std::vector<Search::Entry> entries;
  for (const Triangle &triangle : triangles_)
  {
    Point<3> low = triangle[0], high = triangle[0];
    for (const Point<3> &corner : triangle)
      for (unsigned int d = 0; d < 3; ++d)
      {
        low[d] = std::min(low[d], corner[d]);
        high[d] = std::max(high[d], corner[d]);
      }
    entries.emplace_back(Search::Box(Corner(low[0], low[1], low[2]),
                                     Corner(high[0], high[1], high[2])),
                         static_cast<std::uint32_t>(entries.size()));
  }
  search_ = std::make_shared<Search>(Search{decltype(Search::tree)(entries)});
}


bool LineOfSight::is_blocked(const Point<3> &from, const Point<3> &to) const
{
  using Corner = Search::Corner;
  const auto &tree = search_->tree;
  const bg::model::segment<Corner> segment(Corner(from[0], from[1], from[2]),
                                           Corner(to[0], to[1], to[2]));
  const Tensor<1, 3> way = to - from;
  return std::any_of(tree.qbegin(bg::index::intersects(segment)),
                     tree.qend(),
                     [&](const Search::Entry &entry) {
                       return meets(from, way, triangles_[entry.second]);
                     });
}
} // namespace contrecoup

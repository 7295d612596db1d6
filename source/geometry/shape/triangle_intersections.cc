// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/triangle_intersections.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace contrecoup
{
using dealii::Point;

namespace
{
  // The linear kernel and its predicates are the part of CGAL under the LGPL.
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  namespace bg = boost::geometry;
  using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
  using Box = bg::model::box<Corner>;
  using Entry = std::pair<Box, std::uint32_t>;

  Kernel::Point_3 to_cgal(const Point<3> &x)
  {
    return Kernel::Point_3(x[0], x[1], x[2]);
  }

  Kernel::Triangle_3 to_cgal(const TriangleMesh &mesh, const std::uint32_t t)
  {
    const auto &v = mesh.triangles[t];
    return Kernel::Triangle_3(to_cgal(mesh.vertices[v[0]]),
                              to_cgal(mesh.vertices[v[1]]),
                              to_cgal(mesh.vertices[v[2]]));
  }

  Box box_of_triangle(const TriangleMesh &mesh, const std::uint32_t t)
  {
    Point<3> low = mesh.vertices[mesh.triangles[t][0]];
    Point<3> high = low;
    for (const std::uint32_t vertex : mesh.triangles[t])
      for (unsigned int d = 0; d < 3; ++d)
      {
        low[d] = std::min(low[d], mesh.vertices[vertex][d]);
        high[d] = std::max(high[d], mesh.vertices[vertex][d]);
      }
    return Box(Corner(low[0], low[1], low[2]),
               Corner(high[0], high[1], high[2]));
  }

  /// Whether the edge of triangle a opposite to @p shared meets b.
  bool far_edge_meets(const TriangleMesh &mesh,
                      const std::uint32_t a,
                      const std::uint32_t b,
                      const std::uint32_t shared)
  {
    std::vector<Kernel::Point_3> ends;
    for (const std::uint32_t vertex : mesh.triangles[a])
      if (vertex != shared)
        ends.push_back(to_cgal(mesh.vertices[vertex]));
    return CGAL::do_intersect(Kernel::Segment_3(ends[0], ends[1]),
                              to_cgal(mesh, b));
  }

  bool intersect(const TriangleMesh &mesh,
                 const std::uint32_t a,
                 const std::uint32_t b)
  {
    std::vector<std::uint32_t> shared;
    for (const std::uint32_t vertex : mesh.triangles[a])
      for (const std::uint32_t other : mesh.triangles[b])
        if (vertex == other)
          shared.push_back(vertex);
    if (shared.size() >= 2)
      return false;
    if (shared.size() == 1)
      return far_edge_meets(mesh, a, b, shared[0]) ||
             far_edge_meets(mesh, b, a, shared[0]);
    return CGAL::do_intersect(to_cgal(mesh, a), to_cgal(mesh, b));
  }

  Point<3> middle(const TriangleMesh &mesh, const std::uint32_t t)
  {
    Point<3> sum;
    for (const std::uint32_t vertex : mesh.triangles[t])
      sum += dealii::Tensor<1, 3>(mesh.vertices[vertex]) / 3.;
    return sum;
  }
} // namespace

std::vector<TrianglePair> find_self_intersections(const TriangleMesh &mesh,
                                                  const std::size_t most)
{
  std::vector<Entry> entries;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    entries.emplace_back(box_of_triangle(mesh, t), t);
  const bg::index::rtree<Entry, bg::index::rstar<16>> tree(entries);
  std::vector<TrianglePair> pairs;
  for (const auto &[box, t] : entries)
    for (auto found = tree.qbegin(bg::index::intersects(box));
         found != tree.qend();
         ++found)
    {
      const std::uint32_t other = found->second;
      if (other <= t || !intersect(mesh, t, other))
        continue;
      const bool is_smaller =
        mesh.area_vector(mesh.triangles[t]).norm_square() <
        mesh.area_vector(mesh.triangles[other]).norm_square();
      pairs.push_back({t, other, middle(mesh, is_smaller ? t : other)});
      if (pairs.size() >= most)
        return pairs;
    }
  return pairs;
}
} // namespace contrecoup

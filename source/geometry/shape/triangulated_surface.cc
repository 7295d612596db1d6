// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/triangulated_surface.h>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr std::uint32_t leaf_size = 8;

  using Corners = std::array<Point<3>, 3>;

  /// Point of a triangle nearest to @p p (Ericson 2005, section 5.1.5).
  Point<3> nearest_in_triangle(const Point<3> &p, const Corners &x)
  {
    const Tensor<1, 3> ab = x[1] - x[0];
    const Tensor<1, 3> ac = x[2] - x[0];
    const Tensor<1, 3> ap = p - x[0];
    const double d1 = ab * ap;
    const double d2 = ac * ap;
    if (d1 <= 0. && d2 <= 0.)
      return x[0];
    const Tensor<1, 3> bp = p - x[1];
    const double d3 = ab * bp;
    const double d4 = ac * bp;
    if (d3 >= 0. && d4 <= d3)
      return x[1];
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0. && d1 >= 0. && d3 <= 0.)
      return x[0] + ab * (d1 / (d1 - d3));
    const Tensor<1, 3> cp = p - x[2];
    const double d5 = ab * cp;
    const double d6 = ac * cp;
    if (d6 >= 0. && d5 <= d6)
      return x[2];
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0. && d2 >= 0. && d6 <= 0.)
      return x[0] + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0. && d4 >= d3 && d5 >= d6)
      return x[1] + (x[2] - x[1]) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    const double sum = va + vb + vc;
    return x[0] + ab * (vb / sum) + ac * (vc / sum);
  }

  /// Solid angle of a triangle, positive seen from behind (van Oosterom and
  /// Strackee 1983).
  double solid_angle(const Point<3> &p, const Corners &x)
  {
    const Tensor<1, 3> a = x[0] - p;
    const Tensor<1, 3> b = x[1] - p;
    const Tensor<1, 3> c = x[2] - p;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    return 2. * std::atan2(a * cross_product_3d(b, c),
                           la * lb * lc + (a * b) * lc + (b * c) * la +
                             (c * a) * lb);
  }

  double
  square_to_box(const Point<3> &lower, const Point<3> &upper, const Point<3> &p)
  {
    double square = 0.;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double gap = std::max({lower[d] - p[d], p[d] - upper[d], 0.});
      square += gap * gap;
    }
    return square;
  }

  Corners corners_of(const TriangleMesh &mesh, const std::uint32_t t)
  {
    const auto &v = mesh.triangles[t];
    return {{mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]}};
  }
} // namespace


TriangulatedSurface::TriangulatedSurface(TriangleMesh mesh)
  : mesh_(std::move(mesh))
{
  build(0, mesh_.triangles.size());
}

TriangulatedSurface::Node
TriangulatedSurface::summarise(const std::uint32_t begin,
                               const std::uint32_t end) const
{
  Node node;
  node.begin = begin;
  node.end = 0;
  node.second = 0;
  node.lower = node.upper = mesh_.vertices[mesh_.triangles[begin][0]];
  double total = 0.;
  for (std::uint32_t t = begin; t < end; ++t)
  {
    const Corners x = corners_of(mesh_, t);
    const Tensor<1, 3> area = mesh_.area_vector(mesh_.triangles[t]);
    node.area += area;
    total += area.norm();
    for (const Point<3> &corner : x)
    {
      node.center += Tensor<1, 3>(corner) * (area.norm() / 3.);
      for (unsigned int d = 0; d < 3; ++d)
      {
        node.lower[d] = std::min(node.lower[d], corner[d]);
        node.upper[d] = std::max(node.upper[d], corner[d]);
      }
    }
  }
  node.center /= total;
  node.radius = 0.;
  for (std::uint32_t t = begin; t < end; ++t)
    for (const std::uint32_t vertex : mesh_.triangles[t])
      node.radius =
        std::max(node.radius, node.center.distance(mesh_.vertices[vertex]));
  return node;
}

void TriangulatedSurface::build(const std::uint32_t begin,
                                const std::uint32_t end)
{
  const std::size_t self = nodes_.size();
  nodes_.push_back(summarise(begin, end));
  if (end - begin <= leaf_size)
  {
    nodes_[self].end = end;
    return;
  }
  unsigned int widest = 0;
  const Tensor<1, 3> width = nodes_[self].upper - nodes_[self].lower;
  for (unsigned int d = 1; d < 3; ++d)
    if (width[d] > width[widest])
      widest = d;
  const auto place = [&](const TriangleMesh::Triangle &triangle) {
    double sum = 0.;
    for (const std::uint32_t vertex : triangle)
      sum += mesh_.vertices[vertex][widest];
    return sum;
  };
  const std::uint32_t middle = begin + (end - begin) / 2;
  auto first = mesh_.triangles.begin();
  std::nth_element(
    first + begin,
    first + middle,
    first + end,
    [&](const auto &a, const auto &b) { return place(a) < place(b); });
  build(begin, middle);
  nodes_[self].second = nodes_.size();
  build(middle, end);
}

TriangulatedSurface::Nearest
TriangulatedSurface::nearest(const Point<3> &point) const
{
  Nearest best{std::numeric_limits<double>::max(), {}, 0};
  std::array<std::pair<double, std::uint32_t>, 64> stack;
  unsigned int depth = 0;
  stack[depth++] = {0., 0};
  while (depth > 0)
  {
    const auto [square, index] = stack[--depth];
    if (square >= best.square)
      continue;
    const Node &node = nodes_[index];
    for (std::uint32_t t = node.begin; t < node.end; ++t)
    {
      const Point<3> place = nearest_in_triangle(point, corners_of(mesh_, t));
      const double here = point.distance_square(place);
      if (here < best.square)
        best = {here, place, t};
    }
    if (node.end > 0)
      continue;
    std::array<std::pair<double, std::uint32_t>, 2> children;
    for (unsigned int c = 0; c < 2; ++c)
    {
      const std::uint32_t child = c == 0 ? index + 1 : node.second;
      children[c] = {
        square_to_box(nodes_[child].lower, nodes_[child].upper, point), child};
    }
    // The nearer child is visited first.
    if (children[0].first < children[1].first)
      std::swap(children[0], children[1]);
    stack[depth++] = children[0];
    stack[depth++] = children[1];
  }
  return best;
}

double TriangulatedSurface::winding_number(const Point<3> &point) const
{
  // Beyond twice the radius, the error of a dipole is below 1 %.
  constexpr double reach = 2.;
  double angle = 0.;
  std::array<std::uint32_t, 64> stack;
  unsigned int depth = 0;
  stack[depth++] = 0;
  while (depth > 0)
  {
    const std::uint32_t index = stack[--depth];
    const Node &node = nodes_[index];
    const Tensor<1, 3> offset = node.center - point;
    const double square = offset.norm_square();
    if (square > reach * reach * node.radius * node.radius)
    {
      angle += node.area * offset / (square * std::sqrt(square));
      continue;
    }
    for (std::uint32_t t = node.begin; t < node.end; ++t)
      angle += solid_angle(point, corners_of(mesh_, t));
    if (node.end > 0)
      continue;
    stack[depth++] = index + 1;
    stack[depth++] = node.second;
  }
  return angle / (4. * dealii::numbers::PI);
}

bool TriangulatedSurface::is_inside(const Point<3> &point) const
{
  return square_to_box(nodes_[0].lower, nodes_[0].upper, point) == 0. &&
         winding_number(point) > 0.5;
}

double TriangulatedSurface::value(const Point<3> &point) const
{
  const double distance = std::sqrt(nearest(point).square);
  return is_inside(point) ? -distance : distance;
}

Tensor<1, 3> TriangulatedSurface::gradient(const Point<3> &point) const
{
  const Nearest found = nearest(point);
  const Tensor<1, 3> normal =
    mesh_.area_vector(mesh_.triangles[found.triangle]);
  const Tensor<1, 3> offset = point - found.place;
  const double distance = offset.norm();
  const auto &[lower, upper] = std::tie(nodes_[0].lower, nodes_[0].upper);
  // On the surface the offset has no direction.
  if (distance < 1e-9 * lower.distance(upper))
    return normal / normal.norm();
  return (is_inside(point) ? -1. : 1.) * offset / distance;
}

dealii::BoundingBox<3> TriangulatedSurface::bounding_box() const
{
  return dealii::BoundingBox<3>({nodes_[0].lower, nodes_[0].upper});
}

double TriangulatedSurface::reach(const Tensor<1, 3> &direction) const
{
  double farthest = std::numeric_limits<double>::lowest();
  for (const auto &triangle : mesh_.triangles)
    for (const std::uint32_t vertex : triangle)
      farthest = std::max(farthest, mesh_.vertices[vertex] * direction);
  return farthest;
}
} // namespace contrecoup

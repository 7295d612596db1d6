// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/shape.h>

#include <limits>
#include <queue>
#include <utility>

namespace contrecoup
{
using dealii::BoundingBox;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// Length of the diagonal of a box [m].
  double diagonal(const BoundingBox<3> &box)
  {
    const auto [lower, upper] = box.get_boundary_points();
    return lower.distance(upper);
  }
} // namespace

Tensor<1, 3> Shape::gradient(const Point<3> &point) const
{
  const auto [lower, upper] = bounding_box().get_boundary_points();
  const double step = 1e-6 * lower.distance(upper);
  Tensor<1, 3> result;
  for (unsigned int d = 0; d < 3; ++d)
  {
    Point<3> before = point;
    Point<3> behind = point;
    before[d] -= step;
    behind[d] += step;
    result[d] = (value(behind) - value(before)) / (2. * step);
  }
  return result;
}

double Shape::reach(const Tensor<1, 3> &direction) const
{
  constexpr double accuracy = 1e-4; // of the diagonal
  constexpr unsigned int most_boxes = 20000;
  using Candidate = std::pair<double, BoundingBox<3>>;
  const auto candidate = [&](const BoundingBox<3> &box) {
    double farthest = box.center() * direction;
    for (unsigned int d = 0; d < 3; ++d)
      farthest += 0.5 * box.side_length(d) * std::abs(direction[d]);
    return Candidate(farthest, box);
  };
  const auto is_nearer = [](const Candidate &a, const Candidate &b) {
    return a.first < b.first;
  };
  // Boxes that may hold a part of the shape, those that reach farthest first.
  std::priority_queue<Candidate, std::vector<Candidate>, decltype(is_nearer)>
    open(is_nearer);
  open.push(candidate(bounding_box()));
  const double whole = open.top().first;
  const double tolerance = accuracy * diagonal(open.top().second);
  double found = std::numeric_limits<double>::lowest();
  for (unsigned int i = 0; i < most_boxes && !open.empty(); ++i)
  {
    const auto [farthest, box] = open.top();
    if (farthest <= found + tolerance)
      return farthest;
    open.pop();
    const Point<3> center = box.center();
    const double here = value(center);
    // The ball of this radius lies within the shape, or outside.
    if (here <= 0.)
      found = std::max(found, center * direction - here);
    if (here > 0.5 * diagonal(box))
      continue;
    for (unsigned int v = 0; v < 8; ++v)
      open.push(candidate(
        BoundingBox<3>(std::vector<Point<3>>{center, box.vertex(v)})));
  }
  return open.empty() ? whole : open.top().first;
}

Tensor<1, 3> Shape::normal(const Point<3> &point) const
{
  const Tensor<1, 3> slope = gradient(point);
  const double length = slope.norm();
  if (length > 0.)
    return slope / length;
  return Point<3>::unit_vector(2);
}

Point<3> Shape::project(const Point<3> &point) const
{
  constexpr unsigned int most_steps = 50;
  const auto [lower, upper] = bounding_box().get_boundary_points();
  const double tolerance = 1e-9 * lower.distance(upper);
  Point<3> foot = point;
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    const double here = value(foot);
    if (std::abs(here) < tolerance)
      break;
    const Tensor<1, 3> slope = gradient(foot);
    // A gradient near 0 indicates a ridge, where a full step overshoots.
    foot -= slope * (here / std::max(slope.norm_square(), 0.1));
  }
  return foot;
}

Point<3> Shape::nearest(const Point<3> &point) const
{
  constexpr double accuracy = 1e-3; // of the diagonal, before slide_to()
  constexpr unsigned int most_boxes = 20000;
  using Candidate = std::pair<double, BoundingBox<3>>;
  const auto is_farther = [](const Candidate &a, const Candidate &b) {
    return a.first > b.first;
  };
  // Boxes that may hold a part of the surface, the nearest first.
  std::priority_queue<Candidate, std::vector<Candidate>, decltype(is_farther)>
    open(is_farther);
  const auto push = [&](const BoundingBox<3> &box) {
    open.emplace(distance_to_box(box, point), box);
  };
  push(bounding_box());
  const double tolerance = accuracy * diagonal(bounding_box());
  Point<3> foot = slide_to(point, project(point));
  for (unsigned int i = 0; i < most_boxes && !open.empty() &&
                           open.top().first < foot.distance(point) - tolerance;
       ++i)
  {
    const BoundingBox<3> box = open.top().second;
    open.pop();
    const Point<3> center = box.center();
    if (std::abs(value(center)) > 0.5 * diagonal(box))
      continue;
    const Point<3> found = project(center);
    if (std::abs(value(found)) < tolerance &&
        found.distance(point) < foot.distance(point))
      foot = found;
    for (unsigned int v = 0; v < 8; ++v)
      push(BoundingBox<3>(std::vector<Point<3>>{center, box.vertex(v)}));
  }
  return slide_to(point, foot);
}

Point<3> Shape::slide_to(const Point<3> &point, Point<3> foot) const
{
  constexpr double least_reach = 1e-3, least_gain = 1e-9;
  double reach = 1.;
  while (reach > least_reach)
  {
    const Tensor<1, 3> outward = normal(foot), offset = point - foot;
    const Tensor<1, 3> along = offset - (offset * outward) * outward;
    const Point<3> next = project(foot + reach * along);
    if (next.distance(point) < (1. - least_gain) * foot.distance(point))
      foot = next;
    else
      reach *= 0.5;
  }
  return foot;
}

double Shape::distance(const Point<3> &point) const
{
  const double length = point.distance(project(point));
  return value(point) < 0. ? -length : length;
}

BoundingBox<3> bounding_box(const std::vector<BoundingBox<3>> &boxes)
{
  BoundingBox<3> all = boxes.front();
  for (const BoundingBox<3> &box : boxes)
    all.merge_with(box);
  return all;
}

double distance_to_box(const BoundingBox<3> &box, const Point<3> &point)
{
  const auto &[lower, upper] = box.get_boundary_points();
  double square = 0.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double gap = std::max({lower[d] - point[d], point[d] - upper[d], 0.});
    square += gap * gap;
  }
  return std::sqrt(square);
}
} // namespace contrecoup

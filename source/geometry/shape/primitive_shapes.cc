// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/primitive_shapes.h>

namespace contrecoup
{
using dealii::BoundingBox;
using dealii::Point;
using dealii::Tensor;

namespace
{
  BoundingBox<3> box_around(const Point<3> &center,
                            const Tensor<1, 3> &half_widths)
  {
    return BoundingBox<3>({center - half_widths, center + half_widths});
  }

  Tensor<1, 3> same_in_all(const double length)
  {
    return Tensor<1, 3>({length, length, length});
  }

  /// Normalises @p vector; the z axis for a zero vector.
  Tensor<1, 3> direction(const Tensor<1, 3> &vector)
  {
    const double length = vector.norm();
    return length > 0. ? vector / length
                       : Tensor<1, 3>(Point<3>::unit_vector(2));
  }
} // namespace


Sphere::Sphere(const Point<3> &center, const double radius)
  : center_(center)
  , radius_(radius)
{}

double Sphere::value(const Point<3> &point) const
{
  return point.distance(center_) - radius_;
}

Tensor<1, 3> Sphere::gradient(const Point<3> &point) const
{
  return direction(point - center_);
}

BoundingBox<3> Sphere::bounding_box() const
{
  return box_around(center_, same_in_all(radius_));
}

double Sphere::reach(const Tensor<1, 3> &direction) const
{
  return center_ * direction + radius_;
}


Ellipsoid::Ellipsoid(const Point<3> &center, const Tensor<1, 3> &semi_axes)
  : center_(center)
  , semi_axes_(semi_axes)
{}

bool Ellipsoid::is_inside(const Tensor<1, 3> &offset) const
{
  double sum = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    sum += std::pow(offset[d] / semi_axes_[d], 2);
  return sum < 1.;
}

Tensor<1, 3> Ellipsoid::nearest(const Tensor<1, 3> &offset) const
{
  // The nearest point is x_d = a_d^2 y_d / (a_d^2 + t) with the largest root t
  // of sum (a_d y_d / (a_d^2 + t))^2 = 1. Solving for s, t plus the smallest
  // a_d^2, avoids cancellation. Zero coordinates are moved off the symmetry
  // plane, where the root may be double.
  const double smallest =
    std::min({semi_axes_[0], semi_axes_[1], semi_axes_[2]});
  Tensor<1, 3> y;
  Tensor<1, 3> excess;
  double s = 0.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    excess[d] = semi_axes_[d] * semi_axes_[d] - smallest * smallest;
    y[d] = std::max(std::abs(offset[d]), 1e-12 * smallest);
    s = std::max(s, semi_axes_[d] * y[d] - excess[d]);
  }
  for (unsigned int step = 0; step < 60; ++step)
  {
    double residual = -1.;
    double slope = 0.;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double ratio = semi_axes_[d] * y[d] / (excess[d] + s);
      residual += ratio * ratio;
      slope -= 2. * ratio * ratio / (excess[d] + s);
    }
    if (residual <= 1e-13)
      break;
    s -= residual / slope;
  }
  Tensor<1, 3> foot;
  for (unsigned int d = 0; d < 3; ++d)
    foot[d] = std::copysign(
      semi_axes_[d] * semi_axes_[d] * y[d] / (excess[d] + s), offset[d]);
  return foot;
}

double Ellipsoid::value(const Point<3> &point) const
{
  const Tensor<1, 3> offset = point - center_;
  const double length = (offset - nearest(offset)).norm();
  return is_inside(offset) ? -length : length;
}

Tensor<1, 3> Ellipsoid::gradient(const Point<3> &point) const
{
  Tensor<1, 3> normal = nearest(point - center_);
  for (unsigned int d = 0; d < 3; ++d)
    normal[d] /= semi_axes_[d] * semi_axes_[d];
  return direction(normal);
}

BoundingBox<3> Ellipsoid::bounding_box() const
{
  return box_around(center_, semi_axes_);
}

double Ellipsoid::reach(const Tensor<1, 3> &direction) const
{
  double square = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    square += std::pow(semi_axes_[d] * direction[d], 2);
  return center_ * direction + std::sqrt(square);
}


RoundedBox::RoundedBox(const Point<3> &center,
                       const Tensor<1, 3> &half_widths,
                       const double rounding)
  : center_(center)
  , half_widths_(half_widths)
  , rounding_(rounding)
{}

double RoundedBox::value(const Point<3> &point) const
{
  double outside = 0.;
  double inside = -std::numeric_limits<double>::max();
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double excess =
      std::abs(point[d] - center_[d]) - half_widths_[d] + rounding_;
    outside += std::pow(std::max(excess, 0.), 2);
    inside = std::max(inside, excess);
  }
  return std::sqrt(outside) + std::min(inside, 0.) - rounding_;
}

BoundingBox<3> RoundedBox::bounding_box() const
{
  return box_around(center_, half_widths_);
}

double RoundedBox::reach(const Tensor<1, 3> &direction) const
{
  double result = center_ * direction + rounding_;
  for (unsigned int d = 0; d < 3; ++d)
    result += (half_widths_[d] - rounding_) * std::abs(direction[d]);
  return result;
}


Cylinder::Cylinder(const Point<3> &first,
                   const Point<3> &second,
                   const double radius)
  : middle_(first + 0.5 * (second - first))
  , axis_(direction(second - first))
  , half_length_(0.5 * first.distance(second))
  , radius_(radius)
{}

double Cylinder::value(const Point<3> &point) const
{
  const Tensor<1, 3> offset = point - middle_;
  const double along = offset * axis_;
  const double beyond_end = std::abs(along) - half_length_;
  const double beyond_side = (offset - along * axis_).norm() - radius_;
  return std::hypot(std::max(beyond_end, 0.), std::max(beyond_side, 0.)) +
         std::min(std::max(beyond_end, beyond_side), 0.);
}

BoundingBox<3> Cylinder::bounding_box() const
{
  Tensor<1, 3> half_widths;
  for (unsigned int d = 0; d < 3; ++d)
    half_widths[d] = reach(Point<3>::unit_vector(d)) - middle_[d];
  return box_around(middle_, half_widths);
}

double Cylinder::reach(const Tensor<1, 3> &direction) const
{
  const double cosine = axis_ * direction;
  return middle_ * direction + half_length_ * std::abs(cosine) +
         radius_ * std::sqrt(std::max(0., 1. - cosine * cosine));
}


Sweep::Sweep(const std::vector<Node> &nodes)
  : box_(box_around(nodes.front().center, same_in_all(nodes.front().radius)))
{
  for (const Node &node : nodes)
    box_.merge_with(box_around(node.center, same_in_all(node.radius)));
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    segments_.push_back(make_segment(nodes[i], nodes[i + 1]));
  if (segments_.empty())
    segments_.push_back(make_segment(nodes.front(), nodes.front()));
}

Sweep::Segment Sweep::make_segment(const Node &a, const Node &b)
{
  const double length = a.center.distance(b.center);
  // One ball may contain the other.
  if (length <= std::abs(a.radius - b.radius))
  {
    const Node &larger = a.radius > b.radius ? a : b;
    return {larger.center,
            direction(b.center - a.center),
            0.,
            larger.radius,
            larger.radius,
            0.,
            1.};
  }
  const double sine = (a.radius - b.radius) / length;
  return {a.center,
          (b.center - a.center) / length,
          length,
          a.radius,
          b.radius,
          sine,
          std::sqrt(1. - sine * sine)};
}

double Sweep::distance_to(const Segment &segment,
                          const Point<3> &point,
                          double &on_axis)
{
  const Tensor<1, 3> offset = point - segment.begin;
  const double along = offset * segment.axis;
  const double aside =
    std::sqrt(std::max(0., offset.norm_square() - along * along));
  // Project along the normal of the lateral surface onto the axis.
  on_axis =
    along - (segment.cosine > 0. ? aside * segment.sine / segment.cosine : 0.);
  if (segment.length == 0.)
    on_axis = 0.;
  on_axis = std::min(std::max(on_axis, 0.), segment.length);
  const double fraction = segment.length > 0. ? on_axis / segment.length : 0.;
  const double radius =
    (1. - fraction) * segment.radius_begin + fraction * segment.radius_end;
  return std::hypot(along - on_axis, aside) - radius;
}

double Sweep::value(const Point<3> &point) const
{
  double nearest = std::numeric_limits<double>::max();
  double on_axis = 0.;
  for (const Segment &segment : segments_)
    nearest = std::min(nearest, distance_to(segment, point, on_axis));
  return nearest;
}

Tensor<1, 3> Sweep::gradient(const Point<3> &point) const
{
  double nearest = std::numeric_limits<double>::max();
  Tensor<1, 3> result;
  for (const Segment &segment : segments_)
  {
    double on_axis = 0.;
    const double here = distance_to(segment, point, on_axis);
    if (here < nearest)
    {
      nearest = here;
      result = direction(point - (segment.begin + on_axis * segment.axis));
    }
  }
  return result;
}

BoundingBox<3> Sweep::bounding_box() const
{
  return box_;
}

double Sweep::reach(const Tensor<1, 3> &direction) const
{
  double farthest = std::numeric_limits<double>::lowest();
  for (const Segment &segment : segments_)
  {
    const double begin = segment.begin * direction;
    const double end = begin + segment.length * (segment.axis * direction);
    farthest = std::max(
      {farthest, begin + segment.radius_begin, end + segment.radius_end});
  }
  return farthest;
}


std::vector<Sweep::Node> smooth_curve(const std::vector<Sweep::Node> &nodes,
                                      const unsigned int n_between)
{
  std::vector<Sweep::Node> curve;
  const std::size_t last = nodes.size() - 1;
  for (std::size_t i = 0; i < last; ++i)
    for (unsigned int k = 0; k <= n_between; ++k)
    {
      const double s = k / (n_between + 1.);
      const std::array<double, 4> weights{{0.5 * s * (-1. + s * (2. - s)),
                                           1. + 0.5 * s * s * (3. * s - 5.),
                                           0.5 * s * (1. + s * (4. - 3. * s)),
                                           0.5 * s * s * (s - 1.)}};
      const std::array<std::size_t, 4> near{
        {i == 0 ? 0 : i - 1, i, i + 1, std::min(i + 2, last)}};
      Sweep::Node node{Point<3>(), 0.};
      for (unsigned int j = 0; j < 4; ++j)
      {
        node.center += weights[j] * Tensor<1, 3>(nodes[near[j]].center);
        node.radius += weights[j] * nodes[near[j]].radius;
      }
      curve.push_back(node);
    }
  curve.push_back(nodes.back());
  return curve;
}
} // namespace contrecoup

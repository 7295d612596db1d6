// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/composed_shapes.h>

namespace contrecoup
{
using dealii::BoundingBox;
using dealii::Point;
using dealii::Tensor;

Union::Union(const std::vector<ShapePointer> &parts, const double blend)
  : parts_(parts)
  , blend_(blend)
{
  for (const ShapePointer &part : parts_)
    boxes_.push_back(part->bounding_box());
}

double Union::value(const Point<3> &point) const
{
  double result = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < parts_.size(); ++i)
  {
    // The distance to a part is at least that to its box.
    const double box_distance = distance_to_box(boxes_[i], point);
    if (box_distance > 0. && box_distance >= result + blend_)
      continue;
    const double part = parts_[i]->value(point);
    const double gap = blend_ - std::abs(result - part);
    result = std::min(result, part);
    if (gap > 0.)
      result -= 0.25 * gap * gap / blend_;
  }
  return result;
}

Tensor<1, 3> Union::gradient(const Point<3> &point) const
{
  double result = std::numeric_limits<double>::max();
  Tensor<1, 3> slope;
  for (std::size_t i = 0; i < parts_.size(); ++i)
  {
    const double box_distance = distance_to_box(boxes_[i], point);
    if (box_distance > 0. && box_distance >= result + blend_)
      continue;
    const double part = parts_[i]->value(point);
    const double gap = blend_ - std::abs(result - part);
    const double of_farther = gap > 0. ? 0.5 * gap / blend_ : 0.;
    const bool is_nearer = part < result;
    if (is_nearer || of_farther > 0.)
    {
      const double weight = is_nearer ? 1. - of_farther : of_farther;
      slope = (1. - weight) * slope + weight * parts_[i]->gradient(point);
    }
    result = std::min(result, part);
    if (gap > 0.)
      result -= 0.25 * gap * gap / blend_;
  }
  return slope;
}

BoundingBox<3> Union::bounding_box() const
{
  // A blend adds at most a quarter of its length for each pair of parts that
  // meet; allow for two such pairs.
  BoundingBox<3> box = contrecoup::bounding_box(boxes_);
  box.extend(0.5 * blend_);
  return box;
}

double Union::reach(const Tensor<1, 3> &direction) const
{
  if (blend_ > 0.)
    return Shape::reach(direction);
  double farthest = std::numeric_limits<double>::lowest();
  for (const ShapePointer &part : parts_)
    farthest = std::max(farthest, part->reach(direction));
  return farthest;
}


Intersection::Intersection(ShapePointer first,
                           ShapePointer second,
                           const With side)
  : first_(std::move(first))
  , second_(std::move(second))
  , sign_(side == With::inside ? 1. : -1.)
{}

double Intersection::value(const Point<3> &point) const
{
  return std::max(first_->value(point), sign_ * second_->value(point));
}

Tensor<1, 3> Intersection::gradient(const Point<3> &point) const
{
  return first_->value(point) > sign_ * second_->value(point)
           ? first_->gradient(point)
           : sign_ * second_->gradient(point);
}

BoundingBox<3> Intersection::bounding_box() const
{
  if (sign_ < 0.)
    return first_->bounding_box();
  const auto a = first_->bounding_box().get_boundary_points();
  const auto b = second_->bounding_box().get_boundary_points();
  Point<3> lower;
  Point<3> upper;
  for (unsigned int d = 0; d < 3; ++d)
  {
    lower[d] = std::max(a.first[d], b.first[d]);
    upper[d] = std::max(lower[d], std::min(a.second[d], b.second[d]));
  }
  return BoundingBox<3>({lower, upper});
}


Offset::Offset(ShapePointer shape, const double growth)
  : shape_(std::move(shape))
  , growth_(growth)
{}

double Offset::value(const Point<3> &point) const
{
  return shape_->value(point) - growth_;
}

Tensor<1, 3> Offset::gradient(const Point<3> &point) const
{
  return shape_->gradient(point);
}

BoundingBox<3> Offset::bounding_box() const
{
  BoundingBox<3> box = shape_->bounding_box();
  box.extend(std::max(growth_, 0.));
  return box;
}

double Offset::reach(const Tensor<1, 3> &direction) const
{
  // Inwards, what is thin vanishes.
  return growth_ < 0. ? Shape::reach(direction)
                      : shape_->reach(direction) + growth_;
}


BoundingBox<3> own_box(const Shape &shape)
{
  // reach() is inexact, bounding_box() may be wide: the narrower of both.
  auto [lower, upper] = shape.bounding_box().get_boundary_points();
  for (unsigned int d = 0; d < 3; ++d)
  {
    const Tensor<1, 3> axis = Point<3>::unit_vector(d);
    lower[d] = std::max(lower[d], -shape.reach(-axis));
    upper[d] = std::min(upper[d], shape.reach(axis));
  }
  return BoundingBox<3>({lower, upper});
}


PlacedShape::PlacedShape(ShapePointer shape, const Placement &placement)
  : shape_(std::move(shape))
  , placement_(placement)
  , box_(placement.apply(shape_->bounding_box()))
{}

ShapePointer PlacedShape::in_own_box(ShapePointer shape,
                                     const Placement &placement)
{
  const auto placed =
    std::make_shared<PlacedShape>(std::move(shape), placement);
  if (placement.turns())
    placed->box_ = own_box(*placed);
  return placed;
}

double PlacedShape::value(const Point<3> &point) const
{
  return placement_.scale() * shape_->value(placement_.pull_back(point));
}

Tensor<1, 3> PlacedShape::gradient(const Point<3> &point) const
{
  return placement_.rotate(shape_->gradient(placement_.pull_back(point)));
}

BoundingBox<3> PlacedShape::bounding_box() const
{
  return box_;
}

double PlacedShape::reach(const Tensor<1, 3> &direction) const
{
  return placement_.scale() * shape_->reach(placement_.rotate_back(direction)) +
         placement_.shift() * direction;
}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/placement.h>
#include <contrecoup/geometry/shape/shape.h>

#include <vector>

namespace contrecoup
{
/**
 * Union of shapes. A positive blend length fills the grooves between parts by
 * the smooth minimum of Quilez, min(a, b) - max(k - |a - b|, 0)^2 / (4 k),
 * applied from one part to the next; k is the blend length, and k / 4 the
 * largest added thickness.
 */
class Union : public Shape
{
public:
  /// @param parts at least one
  /// @param blend at least 0 [m]
  explicit Union(const std::vector<ShapePointer> &parts, double blend = 0.);
  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;
  double reach(const dealii::Tensor<1, 3> &direction) const override;

private:
  std::vector<ShapePointer> parts_;
  std::vector<dealii::BoundingBox<3>> boxes_;
  double blend_;
};

/// Intersection of a shape with another or with what is outside of it: max(a,
/// b), max(a, -b).
class Intersection : public Shape
{
public:
  enum class With
  {
    inside,
    outside
  };
  Intersection(ShapePointer first,
               ShapePointer second,
               With side = With::inside);
  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;

private:
  ShapePointer first_;
  ShapePointer second_;
  double sign_; ///< of the second shape's distance
};

/// A shape whose surface is shifted outwards; inwards for growth < 0 [m].
class Offset : public Shape
{
public:
  Offset(ShapePointer shape, double growth);
  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;
  double reach(const dealii::Tensor<1, 3> &direction) const override;

private:
  ShapePointer shape_;
  double growth_;
};

/// The smallest box around a shape [m], by Shape::reach(); that of
/// Shape::bounding_box() may be wider.
dealii::BoundingBox<3> own_box(const Shape &shape);

/// A shape scaled, rotated and shifted.
class PlacedShape : public Shape
{
public:
  /// A shape whose box is that of the turned box.
  PlacedShape(ShapePointer shape, const Placement &placement);

  /// A shape whose box is its own_box() if it is turned.
  static ShapePointer in_own_box(ShapePointer shape,
                                 const Placement &placement);

  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;
  double reach(const dealii::Tensor<1, 3> &direction) const override;

private:
  ShapePointer shape_;
  Placement placement_;
  dealii::BoundingBox<3> box_;
};
} // namespace contrecoup

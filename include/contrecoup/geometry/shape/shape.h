// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <vector>

namespace contrecoup
{
/**
 * A solid in space, represented by a signed distance function: negative
 * inside, positive outside, 0 on the surface; lengths in m. Immutable and
 * thread-safe.
 *
 * value() has the correct sign everywhere and is Lipschitz continuous with
 * constant 1. Its magnitude therefore never exceeds the true distance: a ball
 * around p with a radius below |value(p)| does not meet the surface. The value
 * equals the true distance for primitives, and may be smaller near edges and
 * blends of composed shapes. distance() gives the true distance near the
 * surface.
 */
class Shape
{
public:
  virtual ~Shape() = default;

  /// Signed distance at @p point, or a value of smaller magnitude [m].
  virtual double value(const dealii::Point<3> &point) const = 0;

  /// Gradient of value() [-], which points outwards. By default from central
  /// differences: where the gradient is not unique, the mean of those of both
  /// sides, which may be near 0.
  virtual dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const;

  /// Axis-aligned bounding box [m].
  virtual dealii::BoundingBox<3> bounding_box() const = 0;

  /// Largest coordinate of a point of the shape along the unit vector @p
  /// direction [m]. By a search among boxes unless overridden: never too small,
  /// and too large by at most 1e-4 of the diagonal of bounding_box(), or by
  /// little more where the search would take long.
  virtual double reach(const dealii::Tensor<1, 3> &direction) const;

  /// Outward unit normal of the level set of value() at a point.
  dealii::Tensor<1, 3> normal(const dealii::Point<3> &point) const;

  /// A point of the surface near @p point, by Newton steps along the gradient;
  /// the nearest one if @p point is near a smooth surface.
  dealii::Point<3> project(const dealii::Point<3> &point) const;

  /// The nearest point of the surface to @p point: by a search among boxes to
  /// 1e-3 of the diagonal of bounding_box(), then along the surface.
  dealii::Point<3> nearest(const dealii::Point<3> &point) const;

  /// Signed distance from @p point to its projection by project() [m].
  double distance(const dealii::Point<3> &point) const;

private:
  /// Moves @p foot along the surface to the local minimum of the distance from
  /// @p point.
  dealii::Point<3> slide_to(const dealii::Point<3> &point,
                            dealii::Point<3> foot) const;
};

using ShapePointer = std::shared_ptr<const Shape>;

/// Bounding box of at least one box.
dealii::BoundingBox<3>
bounding_box(const std::vector<dealii::BoundingBox<3>> &boxes);

/// Distance from a point to a box [m]; 0 inside.
double distance_to_box(const dealii::BoundingBox<3> &box,
                       const dealii::Point<3> &point);
} // namespace contrecoup

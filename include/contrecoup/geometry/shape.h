// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <vector>

namespace contrecoup
{
/**
 * A solid in space as its signed distance: negative inside, positive outside,
 * 0 on its surface; lengths in m. Immutable, and safe to ask from several
 * threads at once.
 *
 * value() has the right sign everywhere, never changes by more than the way
 * gone (Lipschitz constant 1), and so never exceeds the true distance: a ball
 * around p of radius below |value(p)| does not meet the surface. The value is
 * the true distance for the primitives, and a smaller number near edges and
 * blends of composed shapes. Whoever needs the true one near the surface asks
 * distance(), which goes to the surface.
 */
class Shape
{
public:
  virtual ~Shape() = default;

  /// Signed distance at @p point, or a number of smaller magnitude [m].
  virtual double value(const dealii::Point<3> &point) const = 0;

  /// Gradient of value() [-], which points out of the shape; any of the
  /// possible ones where it is not unique. By central differences unless a
  /// class knows better.
  virtual dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const;

  /// A box along the axes that holds the shape [m].
  virtual dealii::BoundingBox<3> bounding_box() const = 0;

  /// The outward unit normal of the surface that value() = const has here.
  dealii::Tensor<1, 3> normal(const dealii::Point<3> &point) const;

  /// A point of the surface near @p point, found by Newton steps along the
  /// gradient; the nearest one when @p point is near a smooth surface.
  dealii::Point<3> project(const dealii::Point<3> &point) const;

  /// Signed distance from @p point to project() of it [m].
  double distance(const dealii::Point<3> &point) const;
};

using ShapePointer = std::shared_ptr<const Shape>;

/// The smallest box that holds all @p boxes, of which there is one at least.
dealii::BoundingBox<3>
bounding_box(const std::vector<dealii::BoundingBox<3>> &boxes);

/// Distance from @p point to @p box [m]; 0 inside.
double distance_to_box(const dealii::BoundingBox<3> &box,
                       const dealii::Point<3> &point);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/shape.h>

#include <array>
#include <vector>

namespace contrecoup
{
/// A sphere. Exact distance.
class Sphere : public Shape
{
public:
  /// @param radius positive [m]
  Sphere(const dealii::Point<3> &center, double radius);
  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;
  double reach(const dealii::Tensor<1, 3> &direction) const override;

private:
  dealii::Point<3> center_;
  double radius_;
};

/**
 * An axis-aligned ellipsoid. Exact distance: Newton's method finds the nearest
 * point from the equation of Eberly (2013), "Distance from a point to an
 * ellipse, an ellipsoid, or a hyperellipsoid", which is convex and decreasing,
 * from a known bracket.
 */
class Ellipsoid : public Shape
{
public:
  /// @param semi_axes positive [m]
  Ellipsoid(const dealii::Point<3> &center,
            const dealii::Tensor<1, 3> &semi_axes);
  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;
  double reach(const dealii::Tensor<1, 3> &direction) const override;

private:
  /// Nearest point of the surface, relative to the centre.
  dealii::Tensor<1, 3> nearest(const dealii::Tensor<1, 3> &offset) const;
  bool is_inside(const dealii::Tensor<1, 3> &offset) const;

  dealii::Point<3> center_;
  dealii::Tensor<1, 3> semi_axes_;
};

/// An axis-aligned box with rounded edges. Exact distance.
class RoundedBox : public Shape
{
public:
  /// @param half_widths including the rounding, each at least @p rounding and
  /// positive [m]
  RoundedBox(const dealii::Point<3> &center,
             const dealii::Tensor<1, 3> &half_widths,
             double rounding = 0.);
  double value(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;
  double reach(const dealii::Tensor<1, 3> &direction) const override;

private:
  dealii::Point<3> center_;
  dealii::Tensor<1, 3> half_widths_;
  double rounding_;
};

/// A circular cylinder with flat ends. Exact distance.
class Cylinder : public Shape
{
public:
  /// @param first,second centres of the ends, distinct
  /// @param radius positive [m]
  Cylinder(const dealii::Point<3> &first,
           const dealii::Point<3> &second,
           double radius);
  double value(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;
  double reach(const dealii::Tensor<1, 3> &direction) const override;

private:
  dealii::Point<3> middle_;
  dealii::Tensor<1, 3> axis_; ///< unit vector
  double half_length_;
  double radius_;
};

/**
 * Volume swept by a ball along a polyline, with a radius that varies linearly
 * between nodes. Each segment is the convex hull of the balls at its ends. The
 * distance is exact outside; inside it is that of the nearest segment.
 */
class Sweep : public Shape
{
public:
  struct Node
  {
    dealii::Point<3> center;
    double radius; ///< [m]
  };

  /// @param nodes at least one
  explicit Sweep(const std::vector<Node> &nodes);
  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;
  double reach(const dealii::Tensor<1, 3> &direction) const override;

private:
  /// The convex hull of two balls, with precomputed geometry.
  struct Segment
  {
    dealii::Point<3> begin;
    dealii::Tensor<1, 3> axis; ///< unit vector
    double length;
    double radius_begin;
    double radius_end;
    double sine;   ///< of the angle between axis and lateral surface
    double cosine; ///< of the same angle
  };

  static Segment make_segment(const Node &a, const Node &b);
  /// Signed distance from @p point to a segment [m].
  /// @param on_axis result: centre, on the axis, of the nearest ball
  static double distance_to(const Segment &segment,
                            const dealii::Point<3> &point,
                            double &on_axis);

  std::vector<Segment> segments_;
  dealii::BoundingBox<3> box_;
};

/// Nodes along a Catmull-Rom curve through @p nodes, with @p n_between new
/// nodes between two given ones.
std::vector<Sweep::Node> smooth_curve(const std::vector<Sweep::Node> &nodes,
                                      unsigned int n_between);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape.h>

#include <array>
#include <vector>

namespace contrecoup
{
/// A ball. Exact distance.
class Sphere : public Shape
{
public:
  /// @param radius above 0 [m]
  Sphere(const dealii::Point<3> &center, double radius);
  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;

private:
  dealii::Point<3> center_;
  double radius_;
};

/**
 * An ellipsoid along the axes. Exact distance: the nearest point is found by
 * Newton's method on the equation of Eberly (2013), "Distance from a point to
 * an ellipse, an ellipsoid, or a hyperellipsoid", which is convex and
 * decreasing from a known bracket.
 */
class Ellipsoid : public Shape
{
public:
  /// @param semi_axes above 0 [m]
  Ellipsoid(const dealii::Point<3> &center,
            const dealii::Tensor<1, 3> &semi_axes);
  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;

private:
  /// The nearest point of the surface, relative to the centre.
  dealii::Tensor<1, 3> nearest(const dealii::Tensor<1, 3> &offset) const;
  bool is_inside(const dealii::Tensor<1, 3> &offset) const;

  dealii::Point<3> center_;
  dealii::Tensor<1, 3> semi_axes_;
};

/// A box along the axes with edges rounded by a radius. Exact distance.
class RoundedBox : public Shape
{
public:
  /// @param half_widths of the box with its rounding, each at least
  ///   @p rounding and above 0 [m]
  RoundedBox(const dealii::Point<3> &center,
             const dealii::Tensor<1, 3> &half_widths,
             double rounding = 0.);
  double value(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;

private:
  dealii::Point<3> center_;
  dealii::Tensor<1, 3> half_widths_;
  double rounding_;
};

/// A circular cylinder with flat ends. Exact distance.
class Cylinder : public Shape
{
public:
  /// @param first,second different centres of the ends
  /// @param radius above 0 [m]
  Cylinder(const dealii::Point<3> &first,
           const dealii::Point<3> &second,
           double radius);
  double value(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;

private:
  dealii::Point<3> middle_;
  dealii::Tensor<1, 3> axis_; ///< unit vector
  double half_length_;
  double radius_;
};

/**
 * Balls along a line of straight pieces, with radii that go linearly from one
 * corner to the next: what a thick pen draws. Each piece is the convex hull of
 * the balls at its ends; exact distance outside, and inside to the nearest
 * piece.
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

private:
  /// The hull of two balls, prepared.
  struct Piece
  {
    dealii::Point<3> begin;
    dealii::Tensor<1, 3> axis; ///< unit vector
    double length;
    double radius_begin;
    double radius_end;
    double sine;   ///< of the angle between axis and side
    double cosine; ///< of the same
  };

  static Piece make_piece(const Node &a, const Node &b);
  /// Distance to a piece, and the point of its axis whose ball is nearest.
  static double
  distance_to(const Piece &piece, const dealii::Point<3> &point, double &place);

  std::vector<Piece> pieces_;
  dealii::BoundingBox<3> box_;
};

/// Nodes along a smooth curve (Catmull-Rom) through @p nodes, @p n_between new
/// ones between neighbours.
std::vector<Sweep::Node> smooth_curve(const std::vector<Sweep::Node> &nodes,
                                      unsigned int n_between);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/shape.h>

#include <array>
#include <vector>

namespace contrecoup
{
/// Coordinates along a limb and across it. Orthonormal directions.
struct SectionFrame
{
  dealii::Point<3> origin{};
  dealii::Tensor<1, 3> along{{0., 0., 1.}};
  dealii::Tensor<1, 3> first{{1., 0., 0.}};  ///< across
  dealii::Tensor<1, 3> second{{0., 1., 0.}}; ///< across

  /// Station along the limb and coordinates across it [m].
  std::array<double, 3> coordinates(const dealii::Point<3> &point) const;

  dealii::Point<3> point(const std::array<double, 3> &coordinates) const;
};

/// Where one section of a limb goes.
struct SectionPair
{
  double station = 0.;             ///< of the original [m]
  double new_station = 0.;         ///< [m]
  double center[2] = {0., 0.};     ///< of the original, across [m]
  double new_center[2] = {0., 0.}; ///< [m]
  double ratio[2] = {1., 1.};      ///< of new to original widths [-]
  double turn = 0.;                ///< of the original's axes of width [rad]
  double new_turn = 0.;            ///< [rad]
};

/**
 * A map of space that carries sections of one limb to those of another. Each
 * section is shifted, turned in its plane and scaled along two directions;
 * between given sections all of this is interpolated linearly, beyond them it
 * continues with the values of the last one. The inverse is exact.
 */
class SectionWarp
{
public:
  /// @param pairs at least two, with increasing stations, old and new, and
  /// positive ratios
  SectionWarp(const SectionFrame &frame,
              const SectionFrame &new_frame,
              const std::vector<SectionPair> &pairs);

  dealii::Point<3> apply(const dealii::Point<3> &point) const;

  /// Inverse of apply().
  dealii::Point<3> pull_back(const dealii::Point<3> &point) const;

  /// The section at a station of the original, interpolated.
  SectionPair at(double station) const;

  const std::vector<SectionPair> &pairs() const
  {
    return pairs_;
  }

  const SectionFrame &frame() const
  {
    return frame_;
  }
  const SectionFrame &new_frame() const
  {
    return new_frame_;
  }

private:
  SectionPair interpolate(std::size_t interval, double weight) const;

  SectionFrame frame_;
  SectionFrame new_frame_;
  std::vector<SectionPair> pairs_;
};

/// A shape that a SectionWarp has carried along. value() is that of the
/// original over the largest stretch of the inverse map within the bounding
/// box, and the distance to that box outside of it.
class WarpedShape : public Shape
{
public:
  WarpedShape(ShapePointer shape, const SectionWarp &warp);
  double value(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;

private:
  /// Bounding box of what @p box becomes.
  dealii::BoundingBox<3> warped(const dealii::BoundingBox<3> &box) const;
  /// Largest stretch of the inverse map within a box [-].
  double largest_stretch(const dealii::BoundingBox<3> &box) const;

  ShapePointer shape_;
  SectionWarp warp_;
  dealii::BoundingBox<3> box_;
  double stretch_;
};
} // namespace contrecoup

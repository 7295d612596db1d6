// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>

namespace contrecoup
{
/// A similarity transformation: uniform scaling and rotation about the origin,
/// then a shift: x -> s R x + t.
class Placement
{
public:
  /// The identity.
  Placement();

  /// @param scale positive [-]
  /// @param angles about the fixed axes x, then y, then z [rad]
  /// @param shift [m]
  Placement(double scale,
            const dealii::Tensor<1, 3> &angles,
            const dealii::Tensor<1, 3> &shift);

  /// Declares the entries Scale, Rotation and Shift in the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads these entries from the current subsection.
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Declares the entry Rotation alone.
  /// @param description help text about angles around the axes x, y and z
  static void declare_rotation(dealii::ParameterHandler &prm,
                               const std::string &description);

  /// Reads the entry Rotation. @return angles about the fixed axes [rad]
  static dealii::Tensor<1, 3> read_rotation(dealii::ParameterHandler &prm);

  dealii::Point<3> apply(const dealii::Point<3> &point) const;

  /// Bounding box of the transformed box.
  dealii::BoundingBox<3> apply(const dealii::BoundingBox<3> &box) const;

  /// Inverse of apply().
  dealii::Point<3> pull_back(const dealii::Point<3> &point) const;

  /// Rotates a direction.
  dealii::Tensor<1, 3> rotate(const dealii::Tensor<1, 3> &direction) const
  {
    return rotation_ * direction;
  }

  /// Inverse of rotate().
  dealii::Tensor<1, 3> rotate_back(const dealii::Tensor<1, 3> &direction) const
  {
    return transpose(rotation_) * direction;
  }

  double scale() const
  {
    return scale_;
  }

  const dealii::Tensor<1, 3> &shift() const
  {
    return shift_;
  }

  /// Whether rotate() is not the identity.
  bool turns() const;

  /// Whether apply() is the identity.
  bool is_identity() const;

private:
  double scale_ = 1.;
  dealii::Tensor<2, 3> rotation_;
  dealii::Tensor<1, 3> shift_;
};
} // namespace contrecoup

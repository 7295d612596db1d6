// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/geometry/shape/placement.h>

namespace contrecoup
{
using dealii::BoundingBox;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// Rotation about a coordinate axis.
  Tensor<2, 3> rotation_about(const unsigned int axis, const double angle)
  {
    Tensor<2, 3> result;
    const unsigned int i = (axis + 1) % 3;
    const unsigned int j = (axis + 2) % 3;
    result[axis][axis] = 1.;
    result[i][i] = result[j][j] = std::cos(angle);
    result[i][j] = -std::sin(angle);
    result[j][i] = std::sin(angle);
    return result;
  }
} // namespace

Placement::Placement()
  : Placement(1., {}, {})
{}

Placement::Placement(const double scale,
                     const Tensor<1, 3> &angles,
                     const Tensor<1, 3> &shift)
  : scale_(scale)
  , rotation_(rotation_about(2, angles[2]) * rotation_about(1, angles[1]) *
              rotation_about(0, angles[0]))
  , shift_(shift)
{}

void Placement::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_double(prm,
                 "Scale",
                 "1",
                 1e-6,
                 1e6,
                 "-",
                 "Scale factor of the body about the origin, applied before "
                 "rotation and shift.");
  declare_rotation(prm,
                   "Rotation angles of the body about the fixed axes x, "
                   "then y, then z through the origin.");
  declare_list(prm,
               "Shift",
               "0, 0, 0",
               3,
               3,
               -1e6,
               1e6,
               "m",
               "Shift of the rotated body.");
}

void Placement::parse_parameters(dealii::ParameterHandler &prm)
{
  *this = Placement(
    read_double(prm, "Scale"), read_rotation(prm), read_point<3>(prm, "Shift"));
}

void Placement::declare_rotation(dealii::ParameterHandler &prm,
                                 const std::string &description)
{
  declare_list(
    prm, "Rotation", "0, 0, 0", 3, 3, -360., 360., "degrees", description);
}

Tensor<1, 3> Placement::read_rotation(dealii::ParameterHandler &prm)
{
  return dealii::numbers::PI / 180. * read_point<3>(prm, "Rotation");
}

Point<3> Placement::apply(const Point<3> &point) const
{
  return Point<3>(scale_ * (rotation_ * point) + shift_);
}

BoundingBox<3> Placement::apply(const BoundingBox<3> &box) const
{
  std::vector<Point<3>> corners;
  for (unsigned int v = 0; v < 8; ++v)
    corners.push_back(apply(box.vertex(v)));
  return BoundingBox<3>(corners);
}

Point<3> Placement::pull_back(const Point<3> &point) const
{
  return Point<3>(transpose(rotation_) * (point - shift_) / scale_);
}

bool Placement::turns() const
{
  return rotation_ != Placement().rotation_;
}

bool Placement::is_identity() const
{
  return scale_ == 1. && !turns() && shift_ == Tensor<1, 3>();
}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape.h>
#include <contrecoup/geometry/voxel_mask.h>

#include <vector>

namespace contrecoup
{
/**
 * A solid made of the voxels of an image: distances from their centres,
 * smoothed once by weights 1/4, 1/2, 1/4 in each direction, interpolated
 * trilinearly in between. Its surface lies within a voxel of the faces; each
 * voxel centre is on its right side. Values are divided by their largest slope
 * where that is above 1, so that they do not exceed the distance.
 */
class GridDistance : public Shape
{
public:
  /// @param mask with one voxel inside at least
  /// @param axes,origin centre of voxel i is at axes * i + origin [m]; the
  ///   axes are orthogonal and as long as the mask's spacing
  GridDistance(const VoxelMask &mask,
               const dealii::Tensor<2, 3> &axes,
               const dealii::Tensor<1, 3> &origin);

  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;

private:
  /// A cell of eight voxel centres and a place in it.
  struct Place
  {
    std::array<std::size_t, 3> cell;
    std::array<double, 3> part;  ///< 0 to 1
    dealii::Tensor<1, 3> beyond; ///< from the grid to the point, its axes [m]
  };

  void smooth(const VoxelMask &padded);
  void limit_slope();
  Place locate(const dealii::Point<3> &point) const;
  double interpolate(const Place &place) const;
  dealii::Tensor<1, 3> slope(const Place &place) const;
  double corner(const Place &place, unsigned int c) const;

  std::array<unsigned int, 3> size_;
  std::array<double, 3> spacing_;
  std::vector<float> values_;
  dealii::Tensor<2, 3> rotation_; ///< from the grid's directions to ours
  dealii::Tensor<1, 3> origin_;   ///< of the padded grid
  dealii::BoundingBox<3> box_;
};
} // namespace contrecoup

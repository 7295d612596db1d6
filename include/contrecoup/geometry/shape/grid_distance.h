// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/image/voxel_mask.h>
#include <contrecoup/geometry/shape/shape.h>

#include <vector>

namespace contrecoup
{
/**
 * Shape of a set of voxels. Distances at voxel centres are smoothed once with
 * weights 1/4, 1/2, 1/4 in each direction and interpolated trilinearly. The
 * surface lies within one voxel of the voxel faces, and each voxel centre is
 * on its correct side. If the largest slope exceeds 1, values are divided by
 * it, so that they do not exceed the true distance.
 */
class GridDistance : public Shape
{
public:
  /// @param mask with at least one voxel inside
  /// @param axes voxel axes [m]: orthogonal, with the lengths of the mask's
  /// spacing
  /// @param origin centre of voxel 0 [m]; that of voxel i is axes * i + origin
  GridDistance(const VoxelMask &mask,
               const dealii::Tensor<2, 3> &axes,
               const dealii::Tensor<1, 3> &origin);

  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  /// The box around the faces of all voxels inside, which smoothing never
  /// leaves.
  dealii::BoundingBox<3> bounding_box() const override;

private:
  /// A cell between eight voxel centres, and local coordinates in the cell.
  struct GridLocation
  {
    std::array<std::size_t, 3> cell;
    std::array<double, 3> fraction; ///< local coordinates, 0 to 1
    /// from the grid to an outside point, in grid axes [m]
    dealii::Tensor<1, 3> beyond;
  };

  void smooth(const VoxelMask &padded);
  void limit_slope();
  GridLocation locate(const dealii::Point<3> &point) const;
  double interpolate(const GridLocation &location) const;
  dealii::Tensor<1, 3> slope(const GridLocation &location) const;
  double corner(const GridLocation &location, unsigned int c) const;

  std::array<unsigned int, 3> size_;
  std::array<double, 3> spacing_;
  std::vector<float> values_;
  dealii::Tensor<2, 3> rotation_; ///< from grid axes to space
  dealii::Tensor<1, 3> origin_;   ///< of the padded grid [m]
  dealii::BoundingBox<3> box_;
};
} // namespace contrecoup

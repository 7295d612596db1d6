// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace contrecoup
{
/// A medical image: voxel values and positions. Spatial axes: x forward
/// (anterior), y to the left, z up (superior). The first voxel axis is that
/// nearest to +x, the second that nearest to +y, the third that nearest to +z.
struct VoxelImage
{
  std::string file;
  std::array<unsigned int, 3> size{{0, 0, 0}};
  std::vector<float> values; ///< first index fastest

  /// The centre of voxel i is axes * i + origin [m].
  dealii::Tensor<2, 3> axes;
  dealii::Tensor<1, 3> origin;

  /// For users, on what the file leaves open; warnings begin with "WARNING: ".
  std::vector<std::string> remarks;

  std::size_t
  index(const unsigned int i, const unsigned int j, const unsigned int k) const
  {
    return i + size[0] * (j + static_cast<std::size_t>(size[1]) * k);
  }

  /// Edge lengths of a voxel [m].
  std::array<double, 3> spacing() const;
};

/**
 * Reads NIfTI-1 (.nii, or pairs of .hdr and .img), compressed or not whatever
 * the name, with the nifticlib and zlib libraries. Positions come from the
 * sform if its axes span a space, otherwise the qform, otherwise from voxel
 * sizes; unspecified units are mm. Voxels are sorted along the spatial axes.
 * @throws InputError when the file cannot be read or is cut, has colours or
 * several frames, or degenerate axes
 */
VoxelImage read_image(const std::string &file);

/// @throws InputError unless both images have the same voxels
void require_same_grid(const VoxelImage &a, const VoxelImage &b);
} // namespace contrecoup

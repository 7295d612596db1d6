// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>
#include <vector>

namespace contrecoup
{
/**
 * Thickness of each part of a label map [m]: the median over its voxels of the
 * shortest of the three rows, one along each axis, in which the voxel stands
 * between others of its part; 0 for a part without voxels. A layer at an angle
 * to the axes seems thicker, at most by the square root of 3.
 * @param size voxels per direction
 * @param spacing of the voxels [m]
 * @param parts number of the part of each voxel, first index fastest, or
 * LabelGrid::outside
 * @param n_parts number of parts
 */
std::vector<double> part_thicknesses(const std::array<unsigned int, 3> &size,
                                     const std::array<double, 3> &spacing,
                                     const std::vector<unsigned char> &parts,
                                     unsigned int n_parts);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace contrecoup
{
/// A set of voxels of a regular grid.
struct VoxelMask
{
  std::array<unsigned int, 3> size{{0, 0, 0}};
  std::array<double, 3> spacing{{0., 0., 0.}}; ///< [m]
  std::vector<unsigned char> inside;           ///< 1 or 0, first index fastest

  std::size_t count() const;

  VoxelMask complement() const;
};

/**
 * Distance from each voxel centre to the nearest voxel centre of the set [m];
 * infinite for an empty set. Exact Euclidean distance transform (Felzenszwalb
 * and Huttenlocher 2012: lower envelopes of parabolas, one direction after the
 * other).
 */
std::vector<float> distance_to(const VoxelMask &mask);

/// Dilation: adds all voxels within @p distance [m].
VoxelMask grown(const VoxelMask &mask, double distance);

/// Pads the grid with @p layers empty voxels on every side.
VoxelMask padded(const VoxelMask &mask, unsigned int layers);

/// Morphological closing: dilation, then erosion. Fills gaps narrower than
/// twice @p distance [m]. The grid is padded, so its sides do not act as
/// walls.
VoxelMask closed(const VoxelMask &mask, double distance);

/// Largest face-connected piece.
VoxelMask largest_piece(const VoxelMask &mask);

/// Adds all voxels that cannot be reached from the sides and the top (highest
/// third index) of the grid without crossing the set.
VoxelMask with_filled_holes(const VoxelMask &mask);
} // namespace contrecoup

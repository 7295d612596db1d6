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
 * Distance from the centre of every voxel to the nearest centre of a voxel of
 * the set [m]; infinite for an empty set. Exact (Felzenszwalb and Huttenlocher
 * 2012: the lower envelope of parabolas, one direction after the other).
 */
std::vector<float> distance_to(const VoxelMask &mask);

/// The set with every voxel that is at most @p distance away [m].
VoxelMask grown(const VoxelMask &mask, double distance);

/// The set in a grid with @p layers more voxels on every side.
VoxelMask padded(const VoxelMask &mask, unsigned int layers);

/// Morphological closing: grown, then shrunk again; gaps narrower than twice
/// the distance [m] are filled. The sides of the grid do not count as walls.
VoxelMask closed(const VoxelMask &mask, double distance);

/// The largest piece that is connected through faces.
VoxelMask largest_piece(const VoxelMask &mask);

/// The set with all voxels that cannot be reached from the sides and the top
/// (the highest third index) of the grid without crossing it.
VoxelMask with_filled_holes(const VoxelMask &mask);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/hex_mesh.h>

namespace contrecoup
{
/// Parameters of smooth().
struct SmoothingOptions
{
  unsigned int iterations = 20;
  double smallest_scaled_jacobian = 0.2; ///< lower bound [-], 0 to below 1
};

/// Result of smooth().
struct SmoothingReport
{
  std::size_t n_moved = 0; ///< nodes on boundary and interfaces
  /// nodes with reduced displacement, for element quality
  std::size_t n_held_back = 0;
  double largest_displacement = 0.; ///< [m]
};

/**
 * Smooths boundary and interfaces of a voxel mesh in place with the filter of
 * Taubin (1995): alternating Laplacian steps with factors 0.6307 and -0.6732,
 * which preserve long waves and thus volume. Boundary nodes move with their
 * neighbours on the boundary, other nodes with those on all interfaces.
 * Displacements then diffuse to interior nodes; hanging nodes stay
 * interpolated from their masters. Where the scaled Jacobian of an element
 * falls below the bound, its nodes move back towards their initial positions
 * until no such element is left.
 */
SmoothingReport smooth(HexMesh &mesh, const SmoothingOptions &options);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/hex_mesh.h>

namespace contrecoup
{
/// How smooth() goes about it.
struct SmoothingOptions
{
  unsigned int iterations = 20;
  double smallest_scaled_jacobian = 0.2; ///< [-], 0 to below 1
};

/// What smooth() did.
struct SmoothingReport
{
  std::size_t n_moved = 0;          ///< nodes of boundary and interfaces
  std::size_t n_held_back = 0;      ///< nodes moved less for the sake of shape
  double largest_displacement = 0.; ///< [m]
};

/**
 * Smooths boundary and interfaces of a mesh of cubes in place by the filter of
 * Taubin (1995): alternate Laplacian steps of 0.6307 forwards and -0.6732
 * backwards, which keep long waves and so the volume. Nodes of the boundary
 * follow the boundary alone, others all interfaces. The displacement then
 * spreads to nodes inside, hanging nodes stay between their masters, and
 * wherever an element would have a smaller scaled Jacobian than allowed its
 * nodes go back towards where they were until none has.
 */
SmoothingReport smooth(HexMesh &mesh, const SmoothingOptions &options);
} // namespace contrecoup

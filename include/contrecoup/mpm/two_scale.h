// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/**
 * @file
 * B-splines of a grid as sums of those of the grid with halved cells, between
 * the windows of a tile of level 1 and of the tile of level 0 that would begin
 * at the same place. Along each direction the spline of a node is that of the
 * same place with 6/8 or 1, of the nodes beside it with 1/2, and, if cubic, of
 * the next ones with 1/8. Quadratic splines with their centres at the nodes
 * have their knots in the middles of cells, which are none of halved cells.
 */

namespace contrecoup::mpm
{
/// Nodes of level 0 along an edge, from the window's first one, that a window
/// of level 1 needs.
constexpr int two_scale_nodes = 5;

/// Sets the nodes of a window of level 1 to what splines of level 0 are there.
/// @param degree 1 or 3
void refine_window(const unsigned int degree,
                   const double *coarse,
                   double *fine);

/// The transposed: sets those nodes of level 0.
void coarsen_window(const unsigned int degree,
                    const double *fine,
                    double *coarse);
} // namespace contrecoup::mpm

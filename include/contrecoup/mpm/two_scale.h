// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/**
 * @file
 * Two-scale relation: B-splines of a grid as sums of those of the grid
 * with halved cells. It is applied between the window of a tile of level 1 and
 * that of the tile of level 0 that would begin at the same position. Along each
 * direction the weights of the fine splines are 1 (linear) or 6/8 (cubic) at
 * the same node, 1/2 at its neighbours and, if cubic, 1/8 at the next nodes.
 * Quadratic splines centred at the nodes have their knots in the middle of
 * cells, which are not knots of the fine grid; the relation does not exist for
 * them.
 */

namespace contrecoup::mpm
{
/// Number of nodes of level 0 along an edge, from the first one of the window,
/// that a window of level 1 needs.
constexpr int two_scale_nodes = 5;

/// Sets the nodal values of a window of level 1 to those of the splines of
/// level 0.
/// @param degree 1 or 3
void refine_window(const unsigned int degree,
                   const double *coarse,
                   double *fine);

/// Transposed operation: sets the nodal values of the window of level 0.
void coarsen_window(const unsigned int degree,
                    const double *fine,
                    double *coarse);
} // namespace contrecoup::mpm

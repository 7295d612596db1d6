// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace contrecoup::gas
{
/**
 * @name Outlines of facets
 * Corners of the piece of wall in a subcell, in the coordinates of the unit
 * square or cube: a polygon in 3-D, in the order that gives it an area vector
 * into the gas; in 2-D the points of a line. Pieces that do not touch are
 * joined by edges that are passed there and back again, which adds no area.
 * Empty where there is no wall.
 * @{
 */

/// Outline of the surface between the corners with positive @p distances, which
/// are in the gas, and the others, as positive_fraction() places it: its
/// corners lie on edges and on the diagonals of faces. The area vector is
/// exactly that of LeafShape's openings, and subcells that share a face share
/// the points on it.
template <int dim>
std::vector<dealii::Point<dim>>
cut_outline(const std::array<double, (1U << dim)> &distances);

/// Outline of the closed faces of an open subcell, in deal.II's order.
template <int dim>
std::vector<dealii::Point<dim>>
closed_outline(const std::array<bool, 2 * dim> &is_closed);
/// @}
} // namespace contrecoup::gas

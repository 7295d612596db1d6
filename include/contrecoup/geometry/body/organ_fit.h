// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/shape/section_warp.h>

#include <vector>

namespace contrecoup
{
/// Points all over the surface of a shape, about this distance apart [m].
std::vector<dealii::Point<3>> surface_points(const Shape &shape,
                                             double spacing);

/// Least depth below a surface of points that a warp has carried [m].
double least_depth(const Shape &surface,
                   const SectionWarp &warp,
                   const std::vector<dealii::Point<3>> &points);

/**
 * Narrows sections of a warp around their centres where points that it carries
 * would be less than @p depth below a surface [m].
 */
SectionWarp narrowed(const SectionWarp &warp,
                     const Shape &surface,
                     const std::vector<dealii::Point<3>> &points,
                     double depth);

/**
 * Moves and then shrinks the head, which the last two sections of a warp hold,
 * until points in it are at least @p depth below a surface [m].
 */
SectionWarp with_head_inside(const SectionWarp &warp,
                             const Shape &surface,
                             const std::vector<dealii::Point<3>> &points,
                             double depth);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/triangle_mesh.h>

#include <vector>

namespace contrecoup
{
/// Two intersecting triangles, and the place of the intersection.
struct TrianglePair
{
  std::uint32_t first;
  std::uint32_t second;
  dealii::Point<3> place; ///< centre of the smaller triangle [m]
};

/**
 * Finds intersecting triangles that share no edge, and no vertex at the
 * intersection. Uses the exact predicates of CGAL.
 * @param most largest number of pairs to find
 */
std::vector<TrianglePair> find_self_intersections(const TriangleMesh &mesh,
                                                  std::size_t most = 1000);
} // namespace contrecoup

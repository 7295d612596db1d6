// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/triangle_mesh.h>

#include <vector>

namespace contrecoup
{
/// Two triangles that pass through each other, and a place where they do.
struct TrianglePair
{
  std::uint32_t first;
  std::uint32_t second;
  dealii::Point<3> place; ///< middle of the smaller one [m]
};

/**
 * Triangles that intersect although they share neither an edge nor, at the
 * place, a vertex. Decided with the exact predicates of CGAL.
 * @param most pairs to look for
 */
std::vector<TrianglePair> find_self_intersections(const TriangleMesh &mesh,
                                                  std::size_t most = 1000);
} // namespace contrecoup

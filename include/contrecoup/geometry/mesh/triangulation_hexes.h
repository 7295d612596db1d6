// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/hex_mesh.h>

#include <deal.II/grid/tria.h>

#include <optional>

namespace contrecoup
{
/**
 * Converts the active cells of a deal.II mesh to a HexMesh, with hanging nodes
 * between cells of different levels. Material ids are indices in @p parts.
 * @throws InputError for a material id beyond @p parts
 */
HexMesh to_hex_mesh(const dealii::Triangulation<3> &triangulation,
                    const std::vector<BodyPart> &parts);

/// Moves the inner vertices randomly by a part of the shortest edge there.
void distort(dealii::Triangulation<3> &triangulation, double part);

/// A vertex in the middle of an edge or a face of the boundary: the file had
/// hanging nodes, and cells on both sides of such a face count as boundary.
std::optional<dealii::Point<3>>
find_hanging_vertex(const dealii::Triangulation<3> &triangulation);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/hex_mesh.h>

#include <deal.II/grid/tria.h>

namespace contrecoup
{
/**
 * Converts the active cells of a deal.II mesh to a HexMesh, with hanging nodes
 * between cells of different levels. Material ids are indices in @p parts.
 * @throws InputError for a material id beyond @p parts
 */
HexMesh to_hex_mesh(const dealii::Triangulation<3> &triangulation,
                    const std::vector<BodyPart> &parts);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/hex_mesh.h>

#include <deal.II/grid/tria.h>

namespace contrecoup
{
/**
 * The active cells of a mesh of deal.II as hexahedra; where cells of different
 * levels meet, nodes hang. Material ids are numbers in @p parts.
 * @throws InputError for a material id that is no part
 */
HexMesh to_hex_mesh(const dealii::Triangulation<3> &triangulation,
                    const std::vector<BodyPart> &parts);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/hex_mesh.h>

#include <array>
#include <vector>

namespace contrecoup
{
/// Pairs of cells that share a face. Cells of a mesh with hanging nodes do not
/// share faces there.
std::vector<std::array<std::uint32_t, 2>> neighbors_of(const HexMesh &mesh);

/**
 * Number of face-connected sets of the cells of each label; of all cells at
 * LabelGrid::outside. Faces are those of neighbors_of().
 * @param label of each cell
 */
std::array<unsigned int, 256>
count_components(const HexMesh &mesh, const std::vector<unsigned char> &label);
} // namespace contrecoup

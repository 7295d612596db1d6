// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/hex_mesh.h>

#include <string>
#include <vector>

namespace contrecoup
{
/**
 * @file
 * Stray cells: those of brain, lung, heart or liver that share no face with
 * another cell of their tissue, slivers of an organ in a coarse mesh. Their
 * pressure is that of what surrounds them, which may be harder by far, and
 * would be taken for one of the organ. Thin layers, such as skull and fluid,
 * consist of such cells where a mesh does not resolve them; no measure of
 * injury is made of these.
 */

/**
 * Gives each stray voxel to the part with which it shares most faces; among
 * equals, to that of the lower number. Voxels without neighbours stay.
 * @param parts those of the labels
 * @returns for the log, how many voxels of which tissues
 */
std::vector<std::string> join_strays(const std::vector<BodyPart> &parts,
                                     LabelGrid &grid);

/// Warnings with the number of stray cells of each tissue, of a mesh without
/// hanging nodes that must stay as it is.
std::vector<std::string> stray_warnings(const HexMesh &mesh);
} // namespace contrecoup

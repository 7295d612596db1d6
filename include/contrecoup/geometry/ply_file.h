// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/triangle_mesh.h>

#include <string>

namespace contrecoup
{
/**
 * Reads a surface in the Stanford polygon format (PLY, G. Turk 1994): ASCII
 * and binary of either byte order, with the element "vertex" with x, y and z
 * and the element "face" with a list "vertex_indices" (or "vertex_index").
 * Faces of more than three corners become fans of triangles; what else the file
 * has is passed over. Damaged files are refused, whatever they claim: nothing
 * is made larger than what the file has bytes for.
 * @param unit length of a 1 in the file [m]
 * @throws InputError when the file cannot be read so
 */
TriangleMesh read_ply(const std::string &file, double unit);
} // namespace contrecoup

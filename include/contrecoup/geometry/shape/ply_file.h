// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/triangle_mesh.h>

#include <string>

namespace contrecoup
{
/**
 * Reads a surface in the Stanford polygon format (PLY, G. Turk 1994), ASCII or
 * binary of either byte order, with an element "vertex" with x, y and z, and
 * an element "face" with a list "vertex_indices" (or "vertex_index"). Polygons
 * become fans of triangles; other elements are skipped. No allocation exceeds
 * what the size of the file justifies, so damaged files are refused safely.
 * @param unit length of a 1 in the file [m]
 * @throws InputError for any other content
 */
TriangleMesh read_ply(const std::string &file, double unit);
} // namespace contrecoup

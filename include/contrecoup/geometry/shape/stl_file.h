// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/triangle_mesh.h>

#include <string>
#include <vector>

namespace contrecoup
{
/**
 * Reads a surface in the STL format: binary, or ASCII with keywords in any
 * case. Triangles share no vertices. No allocation exceeds what the size of the
 * file justifies.
 * @param unit length of a 1 in the file [m]
 * @param remarks gets what users should know of the file: bytes after the
 * triangles, a missing end
 * @throws InputError for a file that is cut, with what is missing, and for any
 * other content
 */
TriangleMesh read_stl(const std::string &file,
                      double unit,
                      std::vector<std::string> &remarks);
} // namespace contrecoup

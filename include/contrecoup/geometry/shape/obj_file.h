// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/triangle_mesh.h>

#include <string>

namespace contrecoup
{
/**
 * Reads the vertices ("v") and polygons ("f") of a surface in the OBJ format of
 * Wavefront, in double precision. Polygons become fans of triangles; all else
 * (texture, normals, curves, groups) is skipped.
 * @param unit length of a 1 in the file [m]
 * @throws InputError, which names the line, for a vertex without three numbers
 * and a face with a corner that is no vertex
 */
TriangleMesh read_obj(const std::string &file, double unit);
} // namespace contrecoup

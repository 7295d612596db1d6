// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <istream>
#include <string>

namespace contrecoup
{
/// The formats of meshes of one's own, for messages and help texts.
const std::string &accepted_mesh_formats();

/**
 * Why the content of a mesh file cannot be used: it is binary, or has cells of
 * second order or of other shapes than hexahedra (in three dimensions) and
 * quadrilaterals (in two). Empty where none of these is found: the content may
 * still be damaged. Leaves the stream at its begin.
 * @param ending of the file name: "msh", "vtk", "unv"; nothing is found for
 * others
 */
std::string why_unusable_mesh(std::istream &stream,
                              const std::string &ending,
                              unsigned int dimension);
} // namespace contrecoup

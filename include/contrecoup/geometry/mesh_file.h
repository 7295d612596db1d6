// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <string>

namespace contrecoup
{
/**
 * Reads a mesh of hexahedra or quadrilaterals with deal.II, which tells its
 * format by the ending (.msh, .inp, .ucd, .vtk, .unv).
 * @param path of the file, lengths in m
 * @param entry that named it, for messages
 * @throws InputError when the file cannot be opened or read, has cells of other
 *   shapes, or claims more nodes or cells than it has bytes; distorted cells
 *   pass
 */
template <int dim>
void read_mesh_file(const std::string &path,
                    const std::string &entry,
                    dealii::Triangulation<dim> &mesh);

/**
 * The names that a file of Gmsh (.msh) gives to groups of cells of this
 * dimension, by their numbers, deal.II's material ids; none in other formats.
 * @throws InputError when the file cannot be opened
 */
std::map<unsigned int, std::string>
read_group_names(const std::string &path, const unsigned int dimension);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <string>
#include <vector>

namespace contrecoup
{
/**
 * Reads a mesh of hexahedra or quadrilaterals with deal.II. The file name
 * extension determines the format (.msh, .inp, .ucd, .vtk, .unv); of .inp, the
 * content says whether it is UCD or Abaqus. The material id of a cell is the
 * number of its group. Coincident nodes are merged, see
 * merge_coincident_nodes().
 * @param path of the file, lengths in m
 * @param entry parameter with the path, for error messages
 * @returns lines for the log: on merged nodes, and a warning of a mesh in
 * pieces that share no face
 * @throws InputError when the file cannot be opened or read, is binary, has
 * cells of second order or other shapes, or claims more nodes or cells than it
 * has bytes, and for overlapping cells; distorted cells are accepted
 */
template <int dim>
[[nodiscard]] std::vector<std::string>
read_mesh_file(const std::string &path,
               const std::string &entry,
               dealii::Triangulation<dim> &mesh);

/**
 * Names of the physical groups of this dimension in a Gmsh file (.msh), or of
 * the element sets of an Abaqus file (.inp), by number, which is deal.II's
 * material id; empty for other formats.
 * @throws InputError when the file cannot be opened
 */
std::map<unsigned int, std::string>
read_group_names(const std::string &path, const unsigned int dimension);
} // namespace contrecoup

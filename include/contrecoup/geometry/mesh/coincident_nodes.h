// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/grid/tria.h>

#include <string>

namespace contrecoup
{
/**
 * Merges nodes of the surface that lie at the same place, as where mesh
 * programs write blocks one by one: cells on both sides of such a crack would
 * count as surface, as a wall for gas, and pass through each other as solids.
 * Faces that stay surface keep their numbers.
 * @param mesh that is not refined; one with an edge of no length stays as it
 * is, and so does a mesh in 1-D
 * @param where entry and file, for messages
 * @returns a line for the log with the number of merged nodes; empty for none
 * @throws InputError when a face would belong to more than two cells
 */
template <int dim>
std::string merge_coincident_nodes(dealii::Triangulation<dim> &mesh,
                                   const std::string &where);
} // namespace contrecoup

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
 * count as surface and pass through each other. Numbers of faces are lost if
 * nodes are merged.
 * @param mesh that is not refined, of cells that are not flat
 * @param where entry and file, for the error message
 * @returns a line for the log with the number of merged nodes; empty for none
 * @throws InputError when a face would belong to more than two cells
 */
std::string merge_coincident_nodes(dealii::Triangulation<3> &mesh,
                                   const std::string &where);
} // namespace contrecoup

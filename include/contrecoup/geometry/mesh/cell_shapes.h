// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/grid/tria.h>

#include <string>

namespace contrecoup
{
/**
 * Throws InputError, which begins with @p mesh_name, if the Jacobian
 * determinant at a vertex of an active cell of this rank is not positive: of a
 * coarse mesh, or of cells that a manifold moved in refinement.
 */
template <int dim>
void check_cell_shapes(const dealii::Triangulation<dim> &triangulation,
                       const std::string &mesh_name);
} // namespace contrecoup

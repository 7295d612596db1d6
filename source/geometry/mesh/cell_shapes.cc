// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/mesh/cell_shapes.h>

#include <sstream>

namespace contrecoup
{
template <int dim>
void check_cell_shapes(const dealii::Triangulation<dim> &triangulation,
                       const std::string &mesh_name)
{
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
    {
      if (cell->is_artificial())
        continue;
      // From the edges at the vertex, each taken along the positive coordinate
      // direction.
      dealii::Tensor<2, dim> edges;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const unsigned int bit = 1U << d;
        const auto edge = cell->vertex(v | bit) - cell->vertex(v & ~bit);
        edges[d] = edge;
      }
      const double jacobian = dealii::determinant(edges);
      if (jacobian > 0.)
        continue;
      std::ostringstream message;
      message << mesh_name << ": cell " << cell->active_cell_index()
              << " with centre " << cell->center() << " m";
      if (cell->level() > 0)
        message << ", refined " << cell->level() << " times,";
      message << " is inverted or flat (Jacobian " << jacobian
              << " at a vertex; must be positive)";
      throw InputError(message.str());
    }
}


template void check_cell_shapes(const dealii::Triangulation<1> &,
                                const std::string &);
template void check_cell_shapes(const dealii::Triangulation<2> &,
                                const std::string &);
template void check_cell_shapes(const dealii::Triangulation<3> &,
                                const std::string &);
} // namespace contrecoup

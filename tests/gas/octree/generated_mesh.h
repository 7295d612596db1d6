// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_mesh.h>

#include "scene.h"

#include <functional>

namespace contrecoup::gas
{
/// A mesh from one of deal.II's generators; some of its leaves are refined
/// @p times.
template <int dim>
std::unique_ptr<LeafMesh<dim>>
make_mesh(const std::string &generator,
          const std::string &arguments,
          const unsigned int refinement,
          const unsigned int times = 0,
          const bool rebuilds_always = true,
          const MPI_Comm communicator = MPI_COMM_WORLD,
          const unsigned int cell_degree = 1)
{
  dealii::ParameterHandler prm;
  CoarseMesh<dim>::declare_parameters(prm);
  apply_assignments({parse_override("Domain/Dimension=" + std::to_string(dim)),
                     parse_override("Domain/Mesh=generator"),
                     parse_override("Domain/Generator=" + generator),
                     parse_override("Domain/Generator arguments=" + arguments)},
                    prm);
  CoarseMesh<dim> coarse_mesh;
  coarse_mesh.parse_parameters(prm);
  auto mesh = std::make_unique<LeafMesh<dim>>(communicator);
  mesh->create(coarse_mesh, Precision::double_precision, cell_degree);
  mesh->triangulation().refine_global(refinement);
  mesh->distribute();
  for (unsigned int i = 0; i < times; ++i)
  {
    // As if by chance, but by the leaf alone.
    for (const auto &cell : mesh->triangulation().active_cell_iterators())
      if (cell->is_locally_owned() &&
          std::hash<std::string>()(cell->id().to_string()) % 5 < 2)
        cell->set_refine_flag();
    mesh->triangulation().execute_coarsening_and_refinement();
    if (rebuilds_always || i + 1 == times)
      mesh->distribute();
  }
  return mesh;
}
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/triangulation_hexes.h>
#include <contrecoup/materials/solid_material.h>
#include <contrecoup/materials/tissue_library.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <deal.II/grid/grid_generator.h>

#include <functional>
#include <string>
#include <vector>

namespace contrecoup
{
using Where = std::function<bool(const dealii::Point<3> &)>;

/// Finds the materials of tissues in a set of the library.
inline auto materials_of(const std::string &set)
{
  return [set](const std::vector<Tissue> &tissues) {
    std::vector<SolidMaterial> materials;
    for (const Tissue tissue : tissues)
      materials.push_back(solid_material(find_tissue_properties(set, tissue)));
    return materials;
  };
}

/// A box with a corner in the origin, of bone and, where the middles of
/// elements say so, brain; refined once where others do.
inline HexMesh bone_and_brain(const std::vector<unsigned int> &elements,
                              const dealii::Point<3> &upper,
                              const Where &is_brain,
                              const Where &is_refined)
{
  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::subdivided_hyper_rectangle(
    mesh, elements, dealii::Point<3>(), upper);
  for (const auto &cell : mesh.active_cell_iterators())
  {
    cell->set_material_id(is_brain(cell->center()) ? 1 : 0);
    if (is_refined(cell->center()))
      cell->set_refine_flag();
  }
  mesh.execute_coarsening_and_refinement();
  return to_hex_mesh(mesh,
                     {{"bone", Tissue::skeleton}, {"brain", Tissue::brain}});
}

/// A box of 6 x 4 x 4 elements of 10 mm, part of which may be refined; the
/// upper half is brain.
inline HexMesh half_brain(const bool refined)
{
  return bone_and_brain(
    {6, 4, 4},
    {0.06, 0.04, 0.04},
    [](const auto &x) { return x[2] > 0.02; },
    [&](const auto &x) { return refined && x[0] > 0.03 && x[1] > 0.01; });
}

/// That box, not refined, of the publication's tissues, held and loaded by
/// nothing. Collective.
inline void make_half_brain(solid::SolidBody<double> &body)
{
  body.reinit(half_brain(false),
              materials_of("paper"),
              {},
              solid::Supports(),
              solid::SurfaceLoads(),
              MPI_COMM_WORLD);
}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/scene_check.h>
#include <contrecoup/ale/run/ale_simulation.h>
#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/memory.h>
#include <contrecoup/base/system/text.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
namespace
{
  /// Cell updates per second and core, for estimates only: measured on the
  /// quickstart's head with a processor of 2021.
  constexpr double typical_speed = 2.5e6;

  /// Memory per cell with its nodes and the data of the remap [bytes].
  constexpr double typical_memory = 2500.;
} // namespace


CostEstimate AleSimulation::estimate()
{
  CostEstimate cost;
  cost.cells = impact_.mesh.n_cells();
  cost.memory = typical_memory * cost.cells;
  // The run loop refuses a mesh this large, so do not build it.
  const double available = available_memory(communicator_);
  if (available > 0. && cost.memory > available)
    return cost;
  dealii::Triangulation<3> mesh;
  impact_.mesh.create(mesh);
  impact_.regions.set_regions(mesh, impact_.mesh.layers());
  if (coupling_.active() && impact_.mesh.wedge().active())
    throw InputError("Mesh/Wedge axis: the nodal masses of a wedge do not suit "
                     "Coupling/Scheme = " +
                     coupling_.name() + "; use monolithic");
  coupling_.require_interface(mesh, impact_.regions.regions());
  check_scene(mesh);
  // Nodes of sliding interfaces are double.
  const auto &regions = impact_.regions.regions();
  if (std::none_of(regions.begin(), regions.end(), [](const Region &region) {
        return region.slides;
      }))
    cost.unknowns = 3. * mesh.n_used_vertices() + 2. * cost.cells;
  // Cold gas at rest moves at the speed of a wall.
  const double speed = impact_.regions.largest_speed(mesh) +
                       impact_.mesh.largest_wall_speed(impact_.end_time);
  cost.steps = std::ceil(impact_.end_time * speed /
                         (impact_.courant_number * impact_.mesh.cell_size()));
  rezone_.check_interval(impact_.end_time / cost.steps);
  recorders_.get<HeadMeasures>().check_interval(cost.steps);
  cost.seconds = cost.steps * cost.cells / typical_speed /
                 dealii::Utilities::MPI::n_mpi_processes(communicator_);
  return cost;
}


void AleSimulation::check_scene(const dealii::Triangulation<3> &mesh)
{
  const std::vector<Region> regions = impact_.regions.regions();
  rezone_.check_regions(regions);
  recorders_.get<HeadMeasures>().find(regions, impact_.planes.planes());
  SceneCheck check(impact_);
  const auto &walls = impact_.mesh.walls();
  const bool is_wedge = impact_.mesh.wedge().active();
  std::uint64_t n_free = 0;
  std::vector<std::uint64_t> n_sliding(regions.size(), 0);
  for (const auto &cell : mesh.active_cell_iterators())
  {
    const unsigned int region = cell->material_id();
    for (const unsigned int v : cell->vertex_indices())
      check.add_matter(cell->vertex(v), region);
    for (const unsigned int f : cell->face_indices())
    {
      const auto face = cell->face(f);
      if (!face->at_boundary())
      {
        const unsigned int other = cell->neighbor(f)->material_id();
        n_sliding[region] += regions[other].slides ? 0 : 1;
        continue;
      }
      const auto id = face->boundary_id();
      n_free += walls.count(id) == 0 ? 1 : 0;
      if (id < 1 || id > 3 || !impact_.has_symmetry_plane(id - 1))
        continue;
      // The sides of a wedge stand for planes through its axis.
      dealii::Point<3> place = face->center();
      if (is_wedge)
        place[id - 1] = 0.;
      check.add_on_symmetry_plane(id - 1, place, region);
    }
  }
  Selections surfaces, interfaces;
  for (const ContactPlane &plane : impact_.planes.planes())
    surfaces.add("Plane " + plane.name + "/Point",
                 coordinates(plane.point),
                 "free surface",
                 n_free);
  surfaces.require_some(MPI_COMM_SELF, "all sides of the mesh are walls");
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (regions[i].slides)
      interfaces.add("Region " + regions[i].name + "/Interface",
                     "slip",
                     "face of a region that sticks",
                     n_sliding[i]);
  interfaces.require_some(MPI_COMM_SELF, "");
  const bool has_gas =
    std::any_of(regions.begin(), regions.end(), [](const Region &region) {
      return region.solid() == nullptr &&
             !std::holds_alternative<Tait>(region.law);
    });
  check.check_planes(has_gas || impact_.regions.has_pressure() ||
                     heat_source_.is_active() ||
                     impact_.mesh.largest_wall_speed(impact_.end_time) > 0.);
  check_probes(mesh);
}


void AleSimulation::check_probes(const dealii::Triangulation<3> &mesh) const
{
  for (const dealii::Point<3> &place : impact_.probes)
  {
    double least = std::numeric_limits<double>::max(), diagonal = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      if (const double distance = cell->center().distance(place);
          distance < least)
      {
        least = distance;
        diagonal = cell->diameter();
      }
    if (least > 0.6 * diagonal)
      throw InputError("Probes/Points: (" + coordinates(place) +
                       ") m is outside of the mesh; the centre of the nearest "
                       "cell is " +
                       brief(least) + " m away");
  }
}
} // namespace contrecoup::ale

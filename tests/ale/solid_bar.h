// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/ale/mesh/cell_corners.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <functional>
#include <set>

namespace contrecoup
{
/// A box of cubes of one solid, whose sides are walls but for some.
struct SolidBar
{
  using Vector = dealii::Tensor<1, 3>;

  struct Options
  {
    ale::Region region;
    std::set<dealii::types::boundary_id> free_sides;
    std::vector<ale::ContactPlane> planes;
    Vector acceleration;
    /// Where the mesh's nodes go before the start; empty: they stay.
    std::function<dealii::Point<3>(const dealii::Point<3> &)> position = {};
  };

  /// @param cells in each direction
  /// @param length along x [m]
  SolidBar(const std::vector<unsigned int> &cells,
           const double length,
           const Options &options,
           const std::function<Vector(const dealii::Point<3> &)> &velocity)
  {
    const double h = length / cells[0];
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh,
      cells,
      dealii::Point<3>(),
      dealii::Point<3>(length, cells[1] * h, cells[2] * h),
      true);
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(0);
    if (options.position)
      dealii::GridTools::transform(options.position, mesh);
    space.reinit(mesh, MPI_COMM_WORLD);
    std::map<dealii::types::boundary_id, ale::SlipWalls::Motion> walls;
    for (unsigned int b = 0; b < 6; ++b)
      if (options.free_sides.count(b) == 0)
        walls.emplace(b, [](double) { return 0.; });
    ale::ContactPlanes planes;
    planes.set_planes(options.planes);
    step.reinit(
      space,
      {options.region},
      walls,
      [acceleration = options.acceleration](double) { return acceleration; },
      planes);
    const double density = options.region.solid()->density;
    state.position = space.positions(ale::node_width);
    state.velocity.resize(state.position.size());
    state.mass.resize(space.n_cells());
    for (std::size_t c = 0; c < space.n_cells(); ++c)
      state.mass[c] =
        density *
        hex_moments(ale::corners_of(space.cell(c), state.position)).volume;
    state.energy.resize(space.n_cells());
    state.products.resize(space.n_cells());
    if (options.region.is_viscoelastic())
      state.relaxed.resize(6 * space.n_cells());
    for (std::size_t n = 0; n < space.n_nodes(); ++n)
    {
      const auto v = velocity(place(n));
      for (unsigned int d = 0; d < 3; ++d)
        state.velocity[ale::node_width * n + d] = v[d];
    }
    step.start(state);
  }

  dealii::Point<3> place(const std::size_t node) const
  {
    const double *x = &state.position[ale::node_width * node];
    return {x[0], x[1], x[2]};
  }

  Vector velocity(const std::size_t node) const
  {
    const double *v = &state.velocity[ale::node_width * node];
    return Vector({v[0], v[1], v[2]});
  }

  void run(const double end)
  {
    while (state.time < end * (1. - 1e-12))
      step.advance(state, end - state.time, 0.3);
  }

  /// Internal and kinetic energy less the work from outside, all ranks [J].
  double energy() const
  {
    const auto totals = step.totals(state);
    return totals.internal_energy + totals.kinetic_energy -
           step.external_work();
  }

  dealii::Triangulation<3> mesh;
  ale::HexSpace space;
  ale::LagrangeStep step;
  ale::AleState state;
};

/// E = 1 GPa, Poisson's ratio 0, 1000 kg/m^3, so that waves go at 1000 m/s;
/// without artificial viscosity.
inline ale::Region elastic_region()
{
  SolidMaterial material;
  material.density = 1000.;
  material.bulk_modulus = 1e9 / 3.;
  material.instantaneous_shear = 0.5e9;
  ale::Region region;
  region.law = material;
  region.viscosity = {0., 0., 0.};
  return region;
}
} // namespace contrecoup

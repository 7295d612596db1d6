// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/numerics/element/hex8_moments.h>
#include <contrecoup/numerics/exact/exact_riemann.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <functional>

namespace contrecoup
{
/// State of a gas at rest.
struct SlabGas
{
  double density;
  double pressure;
};

/// A box of gas with walls on all sides.
struct Slab
{
  using Walls = std::map<dealii::types::boundary_id, ale::SlipWalls::Motion>;

  /// @param cells in each direction; cells are cubes
  /// @param length along x
  /// @param moving walls that do not stand still
  /// @param acceleration along x
  /// @param place where a point of the box is put
  Slab(
    const std::vector<unsigned int> &cells,
    const double length,
    const Walls &moving = {},
    const double acceleration = 0.,
    const std::function<dealii::Point<3>(const dealii::Point<3> &)> &place = {})
  {
    const double h = length / cells[0];
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh,
      cells,
      dealii::Point<3>(),
      dealii::Point<3>(length, cells[1] * h, cells[2] * h),
      true);
    if (place)
      dealii::GridTools::transform(place, mesh);
    // deal.II numbers octants, too.
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(0);
    space.reinit(mesh, MPI_COMM_WORLD);
    Walls walls = moving;
    for (unsigned int b = 0; b < 6; ++b)
      walls.emplace(b, [](double) { return 0.; });
    step.reinit(space, {ale::Region()}, walls, [acceleration](double) {
      dealii::Tensor<1, 3> result;
      result[0] = acceleration;
      return result;
    });
    state.position = space.positions(ale::node_width);
    state.velocity.resize(state.position.size());
    state.mass.resize(space.n_cells());
    state.energy.resize(space.n_cells());
    state.products.resize(space.n_cells());
  }

  HexVectors<double> corners(const std::size_t cell) const
  {
    HexVectors<double> result;
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        result[i][d] =
          state.position[ale::node_width * space.cell(cell)[i] + d];
    return result;
  }

  dealii::Point<3> centre(const std::size_t cell) const
  {
    const auto moments = hex_moments(corners(cell));
    return {moments.first[0] / moments.volume,
            moments.first[1] / moments.volume,
            moments.first[2] / moments.volume};
  }

  void fill(const std::function<SlabGas(const dealii::Point<3> &)> &gas)
  {
    for (std::size_t c = 0; c < space.n_cells(); ++c)
    {
      const double volume = hex_moments(corners(c)).volume;
      const SlabGas values = gas(centre(c));
      state.mass[c] = values.density * volume;
      state.energy[c] = values.pressure / 0.4 * volume;
    }
    step.start(state);
  }

  void run(const double end)
  {
    while (state.time < end * (1. - 1e-12))
      step.advance(state, end - state.time, 0.3);
  }

  ale::AleTotals totals() const
  {
    return step.totals(state);
  }

  /// Mean absolute error of the density of Sod's shock tube at @p time.
  double sod_error(const double time) const
  {
    const GasMaterial gas(IdealGas(1.4));
    const ExactRiemann exact({1., 0., 1.}, {0.125, 0., 0.1}, gas);
    const unsigned int n_points = 20;
    double sum = 0., volume = 0.;
    for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
    {
      const auto x = corners(c);
      const double size = hex_moments(x).volume;
      double expected = 0.;
      for (unsigned int i = 0; i < n_points; ++i)
      {
        const double part = (i + 0.5) / n_points;
        const double place = (1. - part) * x[0][0] + part * x[1][0];
        expected += exact.value((place - 0.5) / time).density / n_points;
      }
      sum += std::abs(state.mass[c] - expected * size);
      volume += size;
    }
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD) /
           dealii::Utilities::MPI::sum(volume, MPI_COMM_WORLD);
  }

  dealii::Triangulation<3> mesh;
  ale::HexSpace space;
  ale::LagrangeStep step;
  ale::AleState state;
};
} // namespace contrecoup

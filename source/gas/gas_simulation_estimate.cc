// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/gas_measures.h>
#include <contrecoup/gas/gas_simulation.h>

namespace contrecoup::gas
{
namespace
{
  /// Unknown-updates per second and core of a stage, measured on a 2025
  /// server core with 8 lanes; a prediction within a factor of a few.
  constexpr double typical_throughput = 1e8;

  /// Bytes for each unknown: three copies of the state and what output and
  /// octree need.
  constexpr double bytes_per_unknown = 40.;
} // namespace


template <int dim>
CostEstimate GasSimulation<dim>::estimate()
{
  CostEstimate result;
  double coarse = coarse_mesh_.n_coarse_cells();
  result.cells = coarse * std::pow(2., dim * coarse_mesh_.initial_refinement());
  result.unknowns = result.cells * layout_.n_points * layout_.n_components;
  result.memory = result.unknowns * bytes_per_unknown;

  // The signal rate of the initial state, at the centre of each of at most
  // so many sample cells along an edge, at the finest level.
  const unsigned int n_samples = 64;
  const unsigned int levels = adaptation_parameters_.active
                                ? adaptation_parameters_.most_level
                                : coarse_mesh_.initial_refinement();
  double fastest = 0.;
  for (unsigned int i = 0; i < n_samples; ++i)
  {
    dealii::Point<dim> place;
    for (unsigned int d = 0; d < dim; ++d)
      place[d] =
        coarse_mesh_.lower_corner()[d] +
        (coarse_mesh_.upper_corner()[d] - coarse_mesh_.lower_corner()[d]) *
          (i + 0.5) / n_samples;
    const auto state = initial_state_.value(place);
    fastest = std::max(
      fastest,
      std::sqrt(std::max(0.,
                         material_.sound_speed_squared(
                           state.density, state.pressure, state.products))) +
        state.velocity.norm());
  }
  double rate = 0.;
  for (unsigned int d = 0; d < dim; ++d)
    rate += fastest * coarse_mesh_.coarse_cells(d) * std::pow(2., levels) /
            (coarse_mesh_.upper_corner()[d] - coarse_mesh_.lower_corner()[d]);
  result.steps =
    std::ceil(end_time_ * rate / (scheme_.cfl * scheme_.stability_limit()));
  result.seconds =
    result.steps * result.unknowns * scheme_.time_stepping.stages.size() /
    (typical_throughput *
     dealii::Utilities::MPI::n_mpi_processes(mesh_.communicator()));
  return result;
}


template CostEstimate GasSimulation<1>::estimate();
template CostEstimate GasSimulation<2>::estimate();
template CostEstimate GasSimulation<3>::estimate();
} // namespace contrecoup::gas

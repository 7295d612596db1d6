// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/run/gas_simulation.h>
#include <contrecoup/gas/run/work_forecast.h>

#include <deal.II/base/quadrature_lib.h>

namespace contrecoup::gas
{
namespace
{
  /// Unknown-updates per second and core of a stage, measured on a 2025
  /// server core with 8 lanes; a prediction within a factor of a few.
  double typical_throughput(const Precision precision)
  {
    return precision == Precision::single_precision ? 1.7e8 : 1e8;
  }

  /// Bytes for each unknown: three copies of the state and what output and
  /// octree need.
  double bytes_per_unknown(const Precision precision)
  {
    return precision == Precision::single_precision ? 28. : 40.;
  }

  /// |u| + c [m/s].
  template <int dim>
  double signal_speed(const GasState<dim> &state, const GasMaterial &material)
  {
    const double square = material.sound_speed_squared(
      state.density, state.pressure, state.products);
    return std::sqrt(std::max(0., square)) + state.velocity.norm();
  }

  /// Coarse cells, and the largest signal rate in one [1/s].
  struct CoarseRate
  {
    double n_cells = 0.;
    double rate = 0.;
  };

  /// Of a box, from samples along its diagonal. A detonation has at least the
  /// speed @p least_speed.
  template <int dim>
  CoarseRate rate_in_box(const CoarseMesh<dim> &mesh,
                         const InitialState<dim> &initial_state,
                         const GasMaterial &material,
                         const double least_speed)
  {
    const unsigned int n_samples = 64;
    const auto edges = mesh.upper_corner() - mesh.lower_corner();
    double fastest = least_speed;
    for (unsigned int i = 0; i < n_samples; ++i)
      fastest = std::max(
        fastest,
        signal_speed(initial_state.value(mesh.lower_corner() +
                                         edges * ((i + 0.5) / n_samples)),
                     material));
    CoarseRate result;
    result.n_cells = mesh.n_coarse_cells();
    for (unsigned int d = 0; d < dim; ++d)
      result.rate += fastest * mesh.coarse_cells(d) / edges[d];
    return result;
  }

  /// Of any mesh, which is built for this: sums over directions of the
  /// inverse shortest edge, and samples in each cell.
  template <int dim>
  CoarseRate rate_in_cells(const CoarseMesh<dim> &mesh,
                           const InitialState<dim> &initial_state,
                           const GasMaterial &material,
                           const double least_speed)
  {
    dealii::Triangulation<dim> triangulation;
    mesh.create(triangulation);
    const dealii::QIterated<dim> samples(dealii::QMidpoint<1>(), 4);
    CoarseRate result;
    result.n_cells = triangulation.n_active_cells();
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      LeafBox<dim> shape;
      std::array<double, dim> shortest;
      shortest.fill(std::numeric_limits<double>::max());
      for (const unsigned int v : cell->vertex_indices())
      {
        shape.vertices.push_back(cell->vertex(v));
        for (unsigned int d = 0; d < dim; ++d)
          shortest[d] = std::min(
            shortest[d],
            cell->vertex(v | (1U << d)).distance(cell->vertex(v & ~(1U << d))));
      }
      double fastest = least_speed, rate = 0.;
      for (const auto &x : samples.get_points())
        fastest = std::max(
          fastest, signal_speed(initial_state.value(shape.place(x)), material));
      for (unsigned int d = 0; d < dim; ++d)
        rate += fastest / shortest[d];
      result.rate = std::max(result.rate, rate);
    }
    return result;
  }
} // namespace


template <int dim>
CostEstimate GasSimulation<dim>::estimate()
{
  const CoarseRate coarse =
    coarse_mesh_.is_axis_aligned()
      ? rate_in_box(coarse_mesh_, initial_state_, material_, charges_.speed())
      : rate_in_cells(
          coarse_mesh_, initial_state_, material_, charges_.speed());
  CostEstimate result;
  result.cells =
    body_.empty()
      ? coarse.n_cells * std::pow(2., dim * coarse_mesh_.initial_refinement())
      : n_leaves_with_body();
  result.unknowns = result.cells * layout_.n_points * layout_.n_components;
  result.memory = result.unknowns * bytes_per_unknown(scheme_.precision);
  if (output_.wants_maps())
    result.memory +=
      result.cells * layout_.n_points * sizeof(BlastRecord<float>);

  const unsigned int levels =
    std::max(adaptation_parameters_.active ? adaptation_parameters_.most_level
                                           : coarse_mesh_.initial_refinement(),
             coarse_mesh_.initial_refinement() +
               (body_.empty() ? 0 : body_.most_levels()));
  result.steps = std::ceil(end_time_ * coarse.rate * std::pow(2., levels) /
                           (scheme_.cfl * scheme_.stability_limit()));
  result.seconds =
    result.steps * result.unknowns * scheme_.time_stepping.stages.size() /
    (typical_throughput(scheme_.precision) *
     dealii::Utilities::MPI::n_mpi_processes(mesh_.communicator()));
  return result;
}


template <int dim>
void GasSimulation<dim>::count_work(const double n_made, const double part)
{
  constexpr double memory = 0.99;
  const double n_stages = scheme_.time_stepping.stages.size();
  n_made_ = memory * n_made_ + n_made;
  n_needed_ = memory * n_needed_ + part * n_stages * mesh_.n_owned();
}


template <int dim>
WorkForecast GasSimulation<dim>::expected_work(const double end_time)
{
  const GasState<dim> rest = ambient();
  const WorkForecaster<dim> forecaster(
    mesh_,
    *stepper_,
    *adaptation_,
    modelling_plan_.centre,
    [this](const double time) { return modelling_plan_.expected_front(time); },
    signal_speed(rest, material_));
  const double made =
    dealii::Utilities::MPI::sum(n_made_, mesh_.communicator());
  const double needed =
    dealii::Utilities::MPI::sum(n_needed_, mesh_.communicator());
  // A leaf's unknowns in all Runge-Kutta stages of a step of stable size.
  const double updates = (needed > 0. ? made / needed : 1.) * layout_.n_points *
                         layout_.n_components *
                         scheme_.time_stepping.stages.size() /
                         (scheme_.cfl * scheme_.stability_limit());
  WorkForecast result = forecaster.forecast(time_, end_time);
  for (auto &[until, work] : result)
    work *= updates;
  return result;
}


#define CONTRECOUP_INSTANTIATE(dim)                             \
  template CostEstimate GasSimulation<dim>::estimate();         \
  template void GasSimulation<dim>::count_work(double, double); \
  template WorkForecast GasSimulation<dim>::expected_work(const double)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas

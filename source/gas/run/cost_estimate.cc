// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/run/cost_estimate.h>
#include <contrecoup/gas/state/blast_record.h>
#include <contrecoup/geometry/mesh/leaf_block.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace contrecoup::gas
{
template <int dim>
double signal_speed(const GasState<dim> &state, const GasMaterial &material)
{
  const double square =
    material.sound_speed_squared(state.density, state.pressure, state.products);
  return std::sqrt(std::max(0., square)) + state.velocity.norm();
}


namespace
{
  /// Unknown-updates per second and core of a stage, measured on a 2025
  /// server core with 8 lanes; a prediction within a factor of a few.
  double typical_throughput(const Precision precision)
  {
    return precision == Precision::single_precision ? 1.7e8 : 1e8;
  }

  /// Bytes per unknown: three copies of the state, primitive values in the
  /// finite-volume scheme, buffers for output, and the octree.
  double bytes_per_unknown(const Scheme &scheme)
  {
    const bool is_single = scheme.precision == Precision::single_precision;
    const double of_state = is_single ? 28. : 40.;
    return scheme.kind == Scheme::Kind::finite_volume
             ? of_state + (is_single ? 4. : 8.)
             : of_state;
  }

  /// Coarse cells, and the largest signal rate in one [1/s].
  struct CoarseRate
  {
    double n_cells = 0.;
    double rate = 0.;
  };

  /// Estimate for a box, from samples along its diagonal; with a detonation,
  /// signals are at least as fast as that.
  template <int dim>
  CoarseRate rate_in_box(const GasScene<dim> &scene)
  {
    const CoarseMesh<dim> &mesh = scene.coarse_mesh;
    const unsigned int n_samples = 64;
    const auto edges = mesh.upper_corner() - mesh.lower_corner();
    double fastest = scene.charges.speed();
    for (unsigned int i = 0; i < n_samples; ++i)
      fastest = std::max(
        fastest,
        signal_speed(scene.initial_state.value(mesh.lower_corner() +
                                               edges * ((i + 0.5) / n_samples)),
                     scene.material));
    CoarseRate result;
    result.n_cells = mesh.n_coarse_cells();
    for (unsigned int d = 0; d < dim; ++d)
      result.rate += fastest * mesh.coarse_cells(d) / edges[d];
    return result;
  }

  /// Estimate for any mesh, which is built here: sum over directions of the
  /// inverse shortest edge, and samples in each cell.
  template <int dim>
  CoarseRate rate_in_cells(const GasScene<dim> &scene)
  {
    const CoarseMesh<dim> &mesh = scene.coarse_mesh;
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
      double fastest = scene.charges.speed(), rate = 0.;
      for (const auto &x : samples.get_points())
        fastest =
          std::max(fastest,
                   signal_speed(scene.initial_state.value(shape.place(x)),
                                scene.material));
      for (unsigned int d = 0; d < dim; ++d)
        rate += fastest / shortest[d];
      result.rate = std::max(result.rate, rate);
    }
    return result;
  }


  /// Number of additional leaves at the body in a box at a given refinement
  /// level above the initial one.
  template <int dim>
  double n_leaves_in(const RigidBody &body,
                     const LeafBox<dim> &box,
                     const int level_above_initial)
  {
    if (body.leaf_diagonals_to(box.origin,
                               dealii::Point<dim>(box.origin + box.extents),
                               level_above_initial) >
        RigidBody::max_diagonals_at_body)
      return std::pow(2., dim * std::max(0, -level_above_initial));
    if (level_above_initial >=
        static_cast<int>(body.levels(
          box.origin, dealii::Point<dim>(box.origin + box.extents))))
      return 1.;
    double result = 0.;
    for (unsigned int c = 0; c < (1U << dim); ++c)
    {
      LeafBox<dim> child = box;
      for (unsigned int d = 0; d < dim; ++d)
      {
        child.extents[d] *= 0.5;
        child.origin[d] += ((c >> d) & 1U) * child.extents[d];
      }
      result += n_leaves_in(body, child, level_above_initial + 1);
    }
    return result;
  }


  /// Number of leaves after initial refinement and refinement at the body.
  template <int dim>
  double n_leaves_with_body(const CoarseMesh<dim> &mesh, const RigidBody &body)
  {
    const int refinement = static_cast<int>(mesh.initial_refinement());
    LeafBlock<dim> all;
    dealii::Tensor<1, dim> edges; // of a coarse leaf
    for (unsigned int d = 0; d < dim; ++d)
    {
      all.end[d] = mesh.coarse_cells(d);
      edges[d] = (mesh.upper_corner()[d] - mesh.lower_corner()[d]) / all.end[d];
    }
    const auto box_of = [&](const LeafBlock<dim> &block) {
      LeafBox<dim> box;
      for (unsigned int d = 0; d < dim; ++d)
      {
        box.origin[d] = mesh.lower_corner()[d] + block.begin[d] * edges[d];
        box.extents[d] = (block.end[d] - block.begin[d]) * edges[d];
      }
      return box;
    };
    // Distance to the surface beyond which leaf_diagonals_to() leaves a coarse
    // leaf as it is. If the centre of a block is farther by the block's radius,
    // the whole block is, since distances are Lipschitz continuous.
    const double margin =
      std::ldexp(edges.norm(), -refinement - static_cast<int>(body.levels())) *
      RigidBody::max_diagonals_at_body;
    const auto is_far = [&](const LeafBlock<dim> &block) {
      const LeafBox<dim> box = box_of(block);
      return std::abs(body.value_in_leaf(
               dealii::Point<dim>(box.origin + 0.5 * box.extents))) >
             0.5 * box.extents.norm() + margin;
    };
    return sum_over_leaves<dim>(
      all, is_far, std::pow(2., dim * refinement), [&](const auto &one) {
        return n_leaves_in(body, box_of(one), -refinement);
      });
  }
} // namespace


template <int dim>
CostEstimate estimate_cost(const GasScene<dim> &scene,
                           const AdaptationParameters &adaptation,
                           const bool has_maps,
                           const unsigned int n_ranks)
{
  const CoarseMesh<dim> &mesh = scene.coarse_mesh;
  const Scheme &scheme = scene.scheme;
  const CoarseRate coarse =
    mesh.is_axis_aligned() ? rate_in_box(scene) : rate_in_cells(scene);
  const double n_leaves =
    scene.body.empty()
      ? coarse.n_cells * std::pow(2., dim * mesh.initial_refinement())
      : n_leaves_with_body(mesh, scene.body);
  CostEstimate result;
  result.cells = n_leaves * scene.layout.n_points;
  result.unknowns = result.cells * scene.layout.n_components;
  result.memory = result.unknowns * bytes_per_unknown(scheme);
  if (has_maps)
    result.memory += result.cells * sizeof(BlastRecord<float>);

  const unsigned int levels = std::max(
    adaptation.active ? adaptation.max_level : mesh.initial_refinement(),
    mesh.initial_refinement() +
      (scene.body.empty() ? 0 : scene.body.most_levels()));
  result.steps = std::ceil(scene.end_time * coarse.rate * std::pow(2., levels) /
                           (scheme.cfl * scheme.stability_limit()));
  result.seconds = result.steps * result.unknowns *
                   scheme.time_stepping.stages.size() /
                   (typical_throughput(scheme.precision) * n_ranks);
  return result;
}


#define CONTRECOUP_INSTANTIATE(dim)                                         \
  template double signal_speed(const GasState<dim> &, const GasMaterial &); \
  template CostEstimate estimate_cost(                                      \
    const GasScene<dim> &, const AdaptationParameters &, bool, unsigned int)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas

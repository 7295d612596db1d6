// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/timers.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/run/gas_simulation.h>
#include <contrecoup/geometry/leaf_block.h>

#include <cmath>
#include <sstream>

namespace contrecoup::gas
{
namespace
{
  /// Where a point of a leaf is.
  template <int dim>
  dealii::Point<dim> place_of(const LeafBox<dim> &box,
                              const LeafPoints<dim> &points,
                              const unsigned int q)
  {
    dealii::Point<dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = points.position(points.indices(q)[d]);
    return box.place(x);
  }
} // namespace


template <int dim>
void GasSimulation<dim>::parse_body(ParameterHandler &prm)
{
  body_.parse_parameters(prm);
  loads_.parse_parameters(prm, body_, coarse_mesh_);
  if (body_.empty())
    return;
  body_.check(dim);
  if (dim == 1 || !coarse_mesh_.is_axis_aligned())
    throw InputError("Rigid body/Kind: bodies need Domain/Mesh = box and "
                     "Domain/Dimension = 2 or 3");
  if (scheme_.kind != Scheme::Kind::finite_volume)
    throw InputError(
      "Rigid body/Kind: bodies need Method/Scheme = finite volume");
  const unsigned int least = 4;
  for (const auto &place : probes_.places())
    if (body_.value(place) < -1e-9)
    {
      std::ostringstream message;
      message << "Probes/Points: the point " << place
              << " m is in the rigid body, where there is no gas";
      throw InputError(message.str());
    }
  if (scheme_.n_points % 2 == 1 && body_.most_levels() > 0)
    throw InputError("Rigid body/Levels above 0 need an even number of "
                     "Method/Subcells, not " +
                     std::to_string(scheme_.n_points));
  if (scheme_.n_points < least)
    throw InputError(
      "Rigid body/Kind: bodies need Method/Subcells of 4 or more, "
      "not " +
      std::to_string(scheme_.n_points));
}


template <int dim>
double GasSimulation<dim>::n_leaves_in(const LeafBox<dim> &box,
                                       const int halvings) const
{
  if (body_.layers_to(box.origin,
                      dealii::Point<dim>(box.origin + box.extents),
                      halvings) > RigidBody::at_body)
    return std::pow(2., dim * std::max(0, -halvings));
  if (halvings >= static_cast<int>(body_.levels(
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
    result += n_leaves_in(child, halvings + 1);
  }
  return result;
}


template <int dim>
double GasSimulation<dim>::n_leaves_with_body() const
{
  const int refinement = static_cast<int>(coarse_mesh_.initial_refinement());
  LeafBlock<dim> all;
  dealii::Tensor<1, dim> edges; // of a coarse leaf
  for (unsigned int d = 0; d < dim; ++d)
  {
    all.end[d] = coarse_mesh_.coarse_cells(d);
    edges[d] =
      (coarse_mesh_.upper_corner()[d] - coarse_mesh_.lower_corner()[d]) /
      all.end[d];
  }
  const auto box_of = [&](const LeafBlock<dim> &block) {
    LeafBox<dim> box;
    for (unsigned int d = 0; d < dim; ++d)
    {
      box.origin[d] =
        coarse_mesh_.lower_corner()[d] + block.begin[d] * edges[d];
      box.extents[d] = (block.end[d] - block.begin[d]) * edges[d];
    }
    return box;
  };
  // The room that layers_to() wants between a coarse leaf and the surface, if
  // the whole block has it: distances differ by no more than places do.
  const double room =
    std::ldexp(edges.norm(), -refinement - static_cast<int>(body_.levels())) *
    RigidBody::at_body;
  const auto is_far = [&](const LeafBlock<dim> &block) {
    const LeafBox<dim> box = box_of(block);
    return std::abs(body_.value_in_leaf(
             dealii::Point<dim>(box.origin + 0.5 * box.extents))) >
           0.5 * box.extents.norm() + room;
  };
  return sum_over_leaves<dim>(
    all, is_far, std::pow(2., dim * refinement), [&](const auto &one) {
      return n_leaves_in(box_of(one), -refinement);
    });
}


template <int dim>
void GasSimulation<dim>::cut_leaves()
{
  if constexpr (dim > 1)
    if (!body_.empty())
    {
      const TimerScope timer("body");
      cut_leaves_.reinit(mesh_, layout_, body_);
      field_.set_open_fractions(&cut_leaves_.fractions());
      loads_.set_ambient(ambient().pressure);
      loads_.reinit(mesh_, layout_, cut_leaves_, body_);
    }
}


template <int dim>
double GasSimulation<dim>::body_volume()
{
  if constexpr (dim > 1)
    if (!body_.empty())
    {
      create_octree();
      refine_octree();
      cut_leaves_.reinit(mesh_, layout_, body_);
    }
  return closed_volume();
}


template <int dim>
double GasSimulation<dim>::closed_volume() const
{
  double volume = 0.;
  if constexpr (dim > 1)
    if (!body_.empty())
      for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
        for (unsigned int q = 0; q < layout_.n_points; ++q)
          volume += (1. - cut_leaves_.fractions()(leaf, q)) *
                    point_volume(leaf_box(mesh_, leaf), points_, q);
  return dealii::Utilities::MPI::sum(volume, mesh_.communicator());
}


template <int dim>
void GasSimulation<dim>::fill_closed_cells()
{
  if (body_.empty())
    return;
  const auto rest = conserved_state(ambient(), material_, layout_.n_components);
  const OpenFractions &fractions = cut_leaves_.fractions();
  // Whether there is gas, body, and explosive in the body.
  std::vector<unsigned int> found = {0, 0, 0};
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
  {
    found[0] |= !fractions.is_closed(leaf);
    if (fractions.is_open(leaf))
      continue;
    found[1] = 1;
    const LeafBox<dim> box = leaf_box(mesh_, leaf);
    auto values = field_.leaf(leaf);
    for (unsigned int q = 0; q < layout_.n_points; ++q)
    {
      if (!charges_.empty() && fractions(leaf, q) < 1. &&
          charges_.signed_distance(place_of(box, points_, q)) < 0.)
        found[2] = 1;
      if (fractions(leaf, q) == 0.)
        for (unsigned int c = 0; c < layout_.n_components; ++c)
          values[c * layout_.n_points + q] = rest[c];
    }
    field_.set_leaf(leaf, values);
  }
  dealii::Utilities::MPI::max(found, mesh_.communicator(), found);
  if (found[0] == 0)
    throw InputError("Rigid body: it fills the whole domain and leaves no gas");
  if (found[1] == 0 && body_.is_required())
    throw InputError(
      "Rigid body: no cell of the domain is cut by it or lies in it; "
      "it is elsewhere, or too thin for cells of this size");
  if (found[2] != 0)
    throw InputError("Charges: a charge and the rigid body overlap");
}


#define CONTRECOUP_INSTANTIATE(dim)                                 \
  template void GasSimulation<dim>::parse_body(ParameterHandler &); \
  template void GasSimulation<dim>::cut_leaves();                   \
  template double GasSimulation<dim>::body_volume();                \
  template double GasSimulation<dim>::closed_volume() const;        \
  template double GasSimulation<dim>::n_leaves_with_body() const;   \
  template void GasSimulation<dim>::fill_closed_cells()

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/gas/body/body_in_gas.h>
#include <contrecoup/gas/state/leaf_sampling.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::gas
{
template <int dim>
void BodyInGas<dim>::mesh_changed()
{
  if constexpr (dim > 1)
    if (!empty())
    {
      const TimerScope timer("body");
      cut_leaves_.reinit(mesh_, scene_.layout, scene_.body);
    }
}


template <int dim>
double BodyInGas<dim>::volume() const
{
  double volume = 0.;
  if (!empty())
    for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
      for (unsigned int q = 0; q < scene_.layout.n_points; ++q)
        volume += (1. - cut_leaves_.fractions()(leaf, q)) *
                  point_volume(leaf_box(mesh_, leaf), scene_.points, q);
  return dealii::Utilities::MPI::sum(volume, mesh_.communicator());
}


template <int dim>
void BodyInGas<dim>::fill_closed_cells(GasField &field) const
{
  if (empty())
    return;
  const LeafLayout &layout = scene_.layout;
  const auto rest =
    conserved_state(scene_.ambient(), scene_.material, layout.n_components);
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
    auto values = field.leaf(leaf);
    for (unsigned int q = 0; q < layout.n_points; ++q)
    {
      if (!scene_.charges.empty() && fractions(leaf, q) < 1. &&
          scene_.charges.signed_distance(scene_.place(box, q)) < 0.)
        found[2] = 1;
      if (fractions(leaf, q) == 0.)
        for (unsigned int c = 0; c < layout.n_components; ++c)
          values[c * layout.n_points + q] = rest[c];
    }
    field.set_leaf(leaf, values);
  }
  dealii::Utilities::MPI::max(found, mesh_.communicator(), found);
  if (found[0] == 0)
    throw InputError("Rigid body: it fills the whole domain and leaves no gas");
  if (found[1] == 0 && scene_.body.is_required())
    throw InputError(
      "Rigid body: no cell of the domain is cut by it or lies in it; "
      "it is elsewhere, or too thin for cells of this size");
  if (found[2] != 0)
    throw InputError("Charges: a charge and the rigid body overlap");
}


template class BodyInGas<1>;
template class BodyInGas<2>;
template class BodyInGas<3>;
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/explosive/detonation.h>
#include <contrecoup/gas/octree/leaf_box.h>

namespace contrecoup::gas
{
namespace
{
  /// Earlier than any time of a run [s].
  constexpr double long_ago = -1e300;
} // namespace


template <int dim>
void Detonation<dim>::reinit(const LeafMesh<dim> &mesh,
                             const LeafPoints<dim> &points,
                             const ChargeSet<dim> &charges)
{
  burn_.layout = LeafLayout(dim, points.n(), 1, mesh.precision());
  burn_.speed = charges.speed();
  burn_.ambient_pressure = charges.ambient_pressure();
  burn_.density = charges.density();
  burn_.stiffness = charges.stiffness();
  const unsigned int n_batches = mesh.n_stored_batches();
  start_.clear();
  start_.resize(n_batches * burn_.layout.batch_size(), long_ago);
  rate_.clear();
  rate_.resize(std::size_t(n_batches) * mesh.width(), 1.);
  burns_.assign(std::size_t(n_batches) * mesh.width(), 0);
  end_ = long_ago;
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    set_leaf(leaf, mesh, points, charges);
  end_ = dealii::Utilities::MPI::max(end_, mesh.communicator());

  GhostExchange<dim> exchange;
  exchange.reinit(mesh, burn_.layout);
  exchange.update(start_.data(), rate_.data());
  const unsigned int first = mesh.first_ghost();
  for (unsigned int leaf = first; leaf < first + mesh.n_ghosts(); ++leaf)
    for (unsigned int q = 0; q < burn_.layout.n_points; ++q)
      if (start_[burn_.layout.offset(leaf) + burn_.layout.value(0, q)] >
          long_ago)
        burns_[leaf] = 1;
  burn_.start = start_.data();
  burn_.rate = rate_.data();
  burn_.burns = burns_.data();
}


template <int dim>
void Detonation<dim>::set_leaf(const unsigned int leaf,
                               const LeafMesh<dim> &mesh,
                               const LeafPoints<dim> &points,
                               const ChargeSet<dim> &charges)
{
  const LeafBox<dim> box = leaf_box(mesh, leaf);
  double size = 0.;
  for (unsigned int d = 0; d < dim; ++d)
    size = std::max(size, box.extents[d] / points.n());
  const double width = charges.burn_width * size;
  rate_[leaf] = charges.speed() / width;

  const double diameter = box.extents.norm() / points.n();
  const dealii::Point<dim> center =
    box.origin + dealii::Tensor<1, dim>(box.extents * 0.5);
  if (charges.signed_distance(center) > 0.5 * box.extents.norm() + diameter)
    return;
  for (unsigned int q = 0; q < burn_.layout.n_points; ++q)
  {
    const auto index = points.indices(q);
    dealii::Point<dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = points.position(index[d]);
    const auto time = charges.arrival(box.place(x), diameter, 0.5 * width);
    if (!time)
      continue;
    start_[burn_.layout.offset(leaf) + burn_.layout.value(0, q)] = *time;
    burns_[leaf] = 1;
    end_ = std::max(end_, *time + 1. / rate_[leaf]);
  }
}


template class Detonation<1>;
template class Detonation<2>;
template class Detonation<3>;
} // namespace contrecoup::gas

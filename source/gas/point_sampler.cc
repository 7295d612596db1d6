// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/point_sampler.h>

namespace contrecoup::gas
{
namespace
{
  /// The active cell that holds a point of a box; shared faces belong to
  /// the upper cell.
  template <int dim>
  typename LeafMesh<dim>::CellIterator cell_at(const LeafMesh<dim> &mesh,
                                               const dealii::Point<dim> &point)
  {
    typename LeafMesh<dim>::CellIterator cell(
      &mesh.triangulation(), 0, mesh.coarse_mesh().coarse_cell_at(point));
    while (cell->has_children())
    {
      unsigned int child = 0;
      const auto &low = cell->vertex(0);
      const auto &high = cell->vertex((1U << dim) - 1);
      for (unsigned int d = 0; d < dim; ++d)
        if (point[d] >= 0.5 * (low[d] + high[d]))
          child |= 1U << d;
      cell = cell->child(child);
    }
    return cell;
  }
} // namespace


template <int dim>
void PointSampler<dim>::reinit(const std::vector<dealii::Point<dim>> &places,
                               const LeafMesh<dim> &mesh,
                               const LeafPoints<dim> &points)
{
  communicator_ = mesh.communicator();
  n_places_ = places.size();
  places_.clear();
  const unsigned int n_points = dealii::Utilities::pow(points.n(), dim);
  for (unsigned int i = 0; i < places.size(); ++i)
  {
    const auto cell = cell_at(mesh, places[i]);
    if (!cell->is_locally_owned())
      continue;
    const auto &low = cell->vertex(0);
    const auto &high = cell->vertex((1U << dim) - 1);
    std::array<std::vector<double>, dim> line;
    for (unsigned int d = 0; d < dim; ++d)
      line[d] =
        points.interpolation((places[i][d] - low[d]) / (high[d] - low[d]));
    Place place{i, mesh.leaf_of(cell), std::vector<double>(n_points, 1.)};
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const auto index = points.indices(q);
      for (unsigned int d = 0; d < dim; ++d)
        place.weights[q] *= line[d][index[d]];
    }
    places_.push_back(place);
  }
}


template <int dim>
std::vector<GasState<dim>>
PointSampler<dim>::sample(const GasField &field,
                          const GasMaterial &material) const
{
  const LeafLayout &layout = field.layout();
  const unsigned int nc = layout.n_components;
  std::vector<double> values(n_places_ * nc, 0.);
  for (const Place &place : places_)
  {
    const double *leaf = field.state() + layout.offset(place.leaf);
    for (unsigned int c = 0; c < nc; ++c)
      for (unsigned int q = 0; q < layout.n_points; ++q)
        values[place.index * nc + c] +=
          place.weights[q] * leaf[layout.value(c, q)];
  }
  dealii::Utilities::MPI::sum(values, communicator_, values);
  std::vector<GasState<dim>> states;
  for (std::size_t i = 0; i < n_places_; ++i)
    states.push_back(primitive_state<dim>(&values[i * nc], material));
  return states;
}


template class PointSampler<1>;
template class PointSampler<2>;
template class PointSampler<3>;
} // namespace contrecoup::gas

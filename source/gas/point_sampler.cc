// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/gas/point_sampler.h>

#include <deal.II/fe/mapping_q1.h>

#include <sstream>

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

  /// A leaf that holds a place, and where in it.
  template <int dim>
  struct Holder
  {
    std::string name; ///< of the cell, the same on all ranks; empty: none
    typename LeafMesh<dim>::CellIterator cell;
    dealii::Point<dim> place; ///< relative coordinates
  };

  /// The owned leaf of first name that holds @p place, if any.
  template <int dim>
  Holder<dim> holder_of(const dealii::Point<dim> &place,
                        const LeafMesh<dim> &mesh)
  {
    const double tolerance = 1e-10;
    Holder<dim> holder;
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    {
      const auto &cell = mesh.cell(leaf);
      if (place.distance(cell->center()) > cell->diameter())
        continue;
      dealii::Point<dim> x;
      try
      {
        x = dealii::StaticMappingQ1<dim>::mapping.transform_real_to_unit_cell(
          cell, place);
      }
      catch (const typename dealii::Mapping<dim>::ExcTransformationFailed &)
      {
        continue; // far outside of this leaf
      }
      const std::string name = cell->id().to_string();
      if (dealii::GeometryInfo<dim>::is_inside_unit_cell(x, tolerance) &&
          (holder.name.empty() || name < holder.name))
        holder = {name, cell, x};
    }
    return holder;
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
  if (mesh.coarse_mesh().is_axis_aligned())
    find_in_box(places, mesh, points);
  else
    find_in_cells(places, mesh, points);
}


template <int dim>
void PointSampler<dim>::find_in_box(
  const std::vector<dealii::Point<dim>> &places,
  const LeafMesh<dim> &mesh,
  const LeafPoints<dim> &points)
{
  for (unsigned int i = 0; i < places.size(); ++i)
  {
    const auto cell = cell_at(mesh, places[i]);
    if (!cell->is_locally_owned())
      continue;
    const auto &low = cell->vertex(0);
    const auto &high = cell->vertex((1U << dim) - 1);
    dealii::Point<dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = (places[i][d] - low[d]) / (high[d] - low[d]);
    add_place(i, cell, x, mesh, points);
  }
}


template <int dim>
void PointSampler<dim>::find_in_cells(
  const std::vector<dealii::Point<dim>> &places,
  const LeafMesh<dim> &mesh,
  const LeafPoints<dim> &points)
{
  std::vector<Holder<dim>> holders;
  std::vector<std::string> mine;
  for (const auto &place : places)
  {
    holders.push_back(holder_of(place, mesh));
    mine.push_back(holders.back().name);
  }
  const auto all = dealii::Utilities::MPI::all_gather(communicator_, mine);
  for (unsigned int i = 0; i < places.size(); ++i)
  {
    std::string first;
    for (const auto &names : all)
      if (!names[i].empty() && (first.empty() || names[i] < first))
        first = names[i];
    if (first.empty())
    {
      std::ostringstream message;
      message << "Probes/Points: the point " << places[i]
              << " m is outside of the mesh";
      throw InputError(message.str());
    }
    if (mine[i] == first)
      add_place(i, holders[i].cell, holders[i].place, mesh, points);
  }
}


template <int dim>
void PointSampler<dim>::add_place(
  const unsigned int index,
  const typename LeafMesh<dim>::CellIterator &cell,
  const dealii::Point<dim> &x,
  const LeafMesh<dim> &mesh,
  const LeafPoints<dim> &points)
{
  const unsigned int n_points = dealii::Utilities::pow(points.n(), dim);
  std::array<std::vector<double>, dim> line;
  for (unsigned int d = 0; d < dim; ++d)
    line[d] = points.interpolation(x[d]);
  Place place{index, mesh.leaf_of(cell), std::vector<double>(n_points, 1.)};
  for (unsigned int q = 0; q < n_points; ++q)
  {
    const auto indices = points.indices(q);
    for (unsigned int d = 0; d < dim; ++d)
      place.weights[q] *= line[d][indices[d]];
  }
  places_.push_back(place);
}


template <int dim>
std::vector<GasState<dim>>
PointSampler<dim>::sample(const GasField &field,
                          const GasMaterial &material) const
{
  const LeafLayout &layout = field.layout();
  const unsigned int nc = layout.n_components;
  const unsigned int row = nc + 1; // the last one: burned fraction
  std::vector<double> values(n_places_ * row, 0.);
  for (const Place &place : places_)
  {
    const double *leaf = field.state() + layout.offset(place.leaf);
    for (unsigned int c = 0; c < nc; ++c)
      for (unsigned int q = 0; q < layout.n_points; ++q)
        values[place.index * row + c] +=
          place.weights[q] * leaf[layout.value(c, q)];
    for (unsigned int q = 0; q < layout.n_points; ++q)
      values[place.index * row + nc] +=
        place.weights[q] * field.burned(place.leaf, q);
  }
  dealii::Utilities::MPI::sum(values, communicator_, values);
  std::vector<GasState<dim>> states;
  for (std::size_t i = 0; i < n_places_; ++i)
  {
    states.push_back(primitive_state<dim>(&values[i * row], material));
    states[i].pressure =
      field.exerted_pressure(states[i].pressure, values[i * row + nc]);
  }
  return states;
}


template class PointSampler<1>;
template class PointSampler<2>;
template class PointSampler<3>;
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/gather.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/gas/state/point_sampler.h>

#include <deal.II/fe/mapping_q1.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <sstream>

namespace contrecoup::gas
{
namespace
{
  /// Active cell of a box mesh that contains a point; a shared face belongs to
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

  /// A leaf that contains a position.
  template <int dim>
  struct ContainingLeaf
  {
    std::string name; ///< cell id, equal on all ranks; empty: none
    typename LeafMesh<dim>::CellIterator cell;
    dealii::Point<dim> place; ///< relative coordinates
  };

  /// Owned leaf with the smallest cell id that contains @p place, if any.
  template <int dim>
  ContainingLeaf<dim> containing_leaf(const dealii::Point<dim> &place,
                                      const LeafMesh<dim> &mesh)
  {
    const double tolerance = 1e-10;
    const dealii::Mapping<dim> &mapping =
      mesh.curved_shapes() != nullptr ? mesh.curved_shapes()->mapping()
                                      : dealii::StaticMappingQ1<dim>::mapping;
    ContainingLeaf<dim> leaf_here;
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    {
      const auto &cell = mesh.cell(leaf);
      if (place.distance(cell->center()) > cell->diameter())
        continue;
      dealii::Point<dim> x;
      try
      {
        x = mapping.transform_real_to_unit_cell(cell, place);
      }
      catch (const typename dealii::Mapping<dim>::ExcTransformationFailed &)
      {
        continue; // far outside of this leaf
      }
      const std::string name = cell->id().to_string();
      if (dealii::GeometryInfo<dim>::is_inside_unit_cell(x, tolerance) &&
          (leaf_here.name.empty() || name < leaf_here.name))
        leaf_here = {name, cell, x};
    }
    return leaf_here;
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
  weights_.clear();
  if (mesh.coarse_mesh().is_axis_aligned())
    find_in_box(places, mesh, points);
  else
    find_in_cells(places, mesh, points);
  // Sorted by leaf, so that each leaf is read once.
  std::stable_sort(
    places_.begin(), places_.end(), [](const Place &a, const Place &b) {
      return a.leaf < b.leaf;
    });
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
  std::vector<ContainingLeaf<dim>> containing_leaves;
  std::string mine; // cell ids, one per line
  for (const auto &place : places)
  {
    containing_leaves.push_back(containing_leaf(place, mesh));
    mine += containing_leaves.back().name + '\n';
  }
  std::vector<std::istringstream> all;
  for (const auto &names : gather_texts(communicator_, mine))
    all.emplace_back(names);
  for (unsigned int i = 0; i < places.size(); ++i)
  {
    std::string first;
    for (auto &names : all)
    {
      std::string name;
      std::getline(names, name);
      if (!name.empty() && (first.empty() || name < first))
        first = name;
    }
    if (first.empty())
    {
      std::ostringstream message;
      message << "Probes/Points: the point " << places[i]
              << " m is outside of the mesh";
      throw InputError(message.str());
    }
    if (containing_leaves[i].name == first)
      add_place(
        i, containing_leaves[i].cell, containing_leaves[i].place, mesh, points);
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
  // Tensor product of the weights along the edges, without those that vanish.
  boost::container::small_vector<Weight, 1U << dim> weights{{0, 1.}}, next;
  for (unsigned int d = 0, stride = 1; d < dim; ++d, stride *= points.n())
  {
    const std::vector<double> line = points.interpolation(x[d]);
    next.clear();
    for (unsigned int i = 0; i < line.size(); ++i)
      if (line[i] != 0.)
        for (const auto &[q, weight] : weights)
          next.emplace_back(q + i * stride, weight * line[i]);
    weights.swap(next);
  }
  const auto nearest = std::max_element(
    weights.begin(), weights.end(), [](const Weight &a, const Weight &b) {
      return a.second < b.second;
    });
  const std::size_t begin = weights_.size();
  weights_.insert(weights_.end(), weights.begin(), weights.end());
  places_.push_back(
    {index, mesh.leaf_of(cell), nearest->first, begin, weights_.size()});
}


template <int dim>
boost::iterator_range<const typename PointSampler<dim>::Weight *>
PointSampler<dim>::weights_of(const Place &place) const
{
  return {weights_.data() + place.begin, weights_.data() + place.end};
}


template <int dim>
std::vector<double> PointSampler<dim>::conserved(const GasField &field) const
{
  const unsigned int nc = field.layout().n_components;
  const unsigned int n_points = field.layout().n_points;
  std::vector<double> values(places_.size() * (nc + 1), 0.);
  std::vector<double> leaf;
  for (std::size_t i = 0; i < places_.size(); ++i)
  {
    const Place &place = places_[i];
    if (i == 0 || place.leaf != places_[i - 1].leaf)
      leaf = field.leaf(place.leaf);
    double *value = &values[i * (nc + 1)];
    // Points without gas are skipped unless all are without gas.
    double sum = 0.;
    for (const auto &[q, weight] : weights_of(place))
      if (field.open_fraction(place.leaf, q) > 0.)
        sum += weight;
    const bool is_near_body = sum > 0. && sum < 1. - 1e-9;
    for (const auto &[q, full_weight] : weights_of(place))
    {
      if (is_near_body && field.open_fraction(place.leaf, q) == 0.)
        continue;
      const double weight = is_near_body ? full_weight / sum : full_weight;
      for (unsigned int c = 0; c < nc; ++c)
        value[c] += weight * leaf[c * n_points + q];
      value[nc] += weight * field.burned(place.leaf, q);
    }
  }
  return values;
}


template <int dim>
GasState<dim> PointSampler<dim>::state_of(const double *values,
                                          const GasField &field,
                                          const GasMaterial &material)
{
  auto state = primitive_state<dim>(values, material);
  state.pressure =
    field.exerted_pressure(state.pressure, values[field.layout().n_components]);
  return state;
}


template <int dim>
void PointSampler<dim>::for_each(
  const GasField &field,
  const GasMaterial &material,
  const std::function<void(unsigned int, const GasState<dim> &)> &take) const
{
  const unsigned int row = field.layout().n_components + 1;
  const auto values = conserved(field);
  for (std::size_t i = 0; i < places_.size(); ++i)
    take(places_[i].index, state_of(&values[i * row], field, material));
}


template <int dim>
std::vector<GasState<dim>>
PointSampler<dim>::sample(const GasField &field,
                          const GasMaterial &material) const
{
  const unsigned int row = field.layout().n_components + 1;
  const auto mine = conserved(field);
  std::vector<double> values(n_places_ * row, 0.);
  for (std::size_t i = 0; i < places_.size(); ++i)
    std::copy_n(&mine[i * row], row, &values[places_[i].index * row]);
  dealii::Utilities::MPI::sum(values, communicator_, values);
  std::vector<GasState<dim>> states;
  for (std::size_t i = 0; i < n_places_; ++i)
    states.push_back(state_of(&values[i * row], field, material));
  return states;
}


template <int dim>
std::vector<double> PointSampler<dim>::nearest(
  const unsigned int n_values,
  const std::function<void(unsigned int, unsigned int, double *)> &read) const
{
  std::vector<double> values(n_places_ * n_values, 0.);
  for (const Place &place : places_)
    read(place.leaf, place.nearest, &values[place.index * n_values]);
  dealii::Utilities::MPI::sum(values, communicator_, values);
  return values;
}


template <int dim>
std::vector<unsigned int> PointSampler<dim>::local_places() const
{
  std::vector<unsigned int> result;
  for (const Place &place : places_)
    result.push_back(place.index);
  return result;
}


template class PointSampler<1>;
template class PointSampler<2>;
template class PointSampler<3>;
} // namespace contrecoup::gas

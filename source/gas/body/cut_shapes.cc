// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/cut_shapes.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/geometry/mesh/ghost_cells.h>

#include <algorithm>
#include <optional>

namespace contrecoup::gas
{
namespace
{
  /// Values that tell leaves apart: corner and edge lengths.
  template <int dim>
  std::array<double, 2 * dim> place_of(const LeafBox<dim> &box)
  {
    std::array<double, 2 * dim> result;
    for (unsigned int d = 0; d < dim; ++d)
    {
      result[d] = box.origin[d];
      result[dim + d] = box.extents[d];
    }
    return result;
  }
} // namespace


template <int dim>
void CutShapes<dim>::measure(const LeafMesh<dim> &mesh,
                             const LeafLayout &layout,
                             const RigidBody &body)
{
  mesh_ = &mesh;
  body_ = &body;
  layout_ = layout;
  const unsigned int n_stored = mesh.n_stored_batches() * mesh.width();
  fractions_.reinit(n_stored, layout_.n_points);
  const bool is_plane = radial_exponent(mesh.coarse_mesh().geometry()) == 0;
  radii_.assign(is_plane ? 0 : n_stored, {});
  shape_of_.assign(n_stored, open);
  changed_of_.assign(n_stored, open);
  changed_shapes_.clear();
  former_memory_ = std::move(memory_);
  memory_ = {};
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    measure(leaf_box(mesh, leaf), leaf);
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    if (cell->is_ghost() && mesh.leaf_of(cell) != no_leaf)
    {
      LeafBox<dim> box;
      box.origin = cell->vertex(0);
      box.extents = cell->vertex((1U << dim) - 1) - cell->vertex(0);
      measure(box, mesh.leaf_of(cell));
    }
  former_memory_ = {};
}


template <int dim>
void CutShapes<dim>::measure(const LeafBox<dim> &box, const unsigned int leaf)
{
  if (!radii_.empty())
    radii_[leaf] = {{box.origin[0], box.extents[0] / layout_.n}};
  const double radius =
    box.extents.norm() * (0.5 + 1. / layout_.n) * (1. + 1e-9);
  const double value =
    body_->value_in_leaf(dealii::Point<dim>(box.origin + box.extents * 0.5));
  if (value > radius)
    return;
  const int number = value < -radius ? closed : find_shape(box);
  if (number == closed)
    fractions_.close(leaf);
  if (number < 0)
    return;
  shape_of_[leaf] = number;
  fractions_.set(leaf, memory_.shapes[number].fraction);
}


template <int dim>
int CutShapes<dim>::find_shape(const LeafBox<dim> &box)
{
  const Place place = place_of(box);
  int &number = memory_.index[place];
  number = static_cast<int>(memory_.shapes.size());
  const auto known = former_memory_.index.find(place);
  if (known == former_memory_.index.end())
  {
    Shape shape = is_staircase()
                    ? staircase_shape(box, layout_, *body_)
                    : cut_shape(box, layout_, *body_, !radii_.empty());
    const auto &parts = shape.fraction;
    if (shape.is_open())
      return number = open;
    if (*std::max_element(parts.begin(), parts.end()) == 0.)
      return number = closed;
    memory_.shapes.push_back(std::move(shape));
    return number;
  }
  const int former = known->second;
  if (former < 0)
    return number = former;
  memory_.shapes.push_back(std::move(former_memory_.shapes[former]));
  return number;
}


template <int dim>
typename CutShapes<dim>::Shape &
CutShapes<dim>::changed_shape(const unsigned int leaf)
{
  if (changed_of_[leaf] < 0)
  {
    Shape copy;
    if (const Shape *known = shape(leaf))
      copy = *known;
    else
    {
      copy.fraction.assign(layout_.n_points, 1.);
      for (auto &faces : copy.opening)
        faces.assign((layout_.n + 1) * layout_.n_face_points, 1.);
      fractions_.set(leaf, copy.fraction);
    }
    changed_of_[leaf] = static_cast<int>(changed_shapes_.size());
    changed_shapes_.push_back(std::move(copy));
  }
  return changed_shapes_[changed_of_[leaf]];
}


template <int dim>
void CutShapes<dim>::close(const Subcell &cell)
{
  Shape &shape = changed_shape(cell.leaf);
  shape.fraction[cell.point] = 0.;
  for (unsigned int face = 0; face < 2 * dim; ++face)
    shape.opening[face / 2][layer_of(cell, face) * layout_.n_face_points +
                            line_of(cell.point, face / 2)] = 0.;
}


template <int dim>
void CutShapes<dim>::update_ghosts()
{
  using Iterator = typename dealii::Triangulation<dim>::active_cell_iterator;
  if (dealii::Utilities::MPI::n_mpi_processes(mesh_->communicator()) == 1)
    return;
  using Values = std::vector<std::vector<double>>;
  const auto pack = [this](const Iterator &cell) -> std::optional<Values> {
    const unsigned int leaf = mesh_->leaf_of(cell);
    if (changed_of_[leaf] < 0)
      return {};
    const Shape &shape = changed_shape(leaf);
    Values values(shape.opening.begin(), shape.opening.end());
    values.push_back(shape.fraction);
    return values;
  };
  const auto unpack = [this](const Iterator &cell, const Values &values) {
    const unsigned int leaf = mesh_->leaf_of(cell);
    if (leaf == no_leaf)
      return;
    Shape &shape = changed_shape(leaf);
    std::copy_n(values.begin(), dim, shape.opening.begin());
    shape.fraction = values.back();
    update_fractions(leaf);
  };
  exchange_with_ghosts<dim, Values>(mesh_->triangulation(), pack, unpack);
}


template <int dim>
double CutShapes<dim>::opening(const Subcell &cell,
                               const unsigned int face) const
{
  const Shape *here = shape(cell.leaf);
  if (here == nullptr)
    return fractions_.is_open(cell.leaf) ? 1. : 0.;
  return here->opening[face / 2][layer_of(cell, face) * layout_.n_face_points +
                                 line_of(cell.point, face / 2)];
}


template <int dim>
double CutShapes<dim>::radius(const Subcell &cell) const
{
  if (radii_.empty())
    return 1.;
  const auto &[inner, edge] = radii_[cell.leaf];
  return inner + (cell.point % layout_.n + 0.5) * edge;
}


template <int dim>
double CutShapes<dim>::cell_volume(const Subcell &cell) const
{
  double result = radii_.empty() ? 1. : 2. * dealii::numbers::PI * radius(cell);
  const auto extents = leaf_box(*mesh_, cell.leaf).extents;
  for (unsigned int d = 0; d < dim; ++d)
    result *= extents[d] / layout_.n;
  return result;
}


template class CutShapes<2>;
template class CutShapes<3>;
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/cut_leaves.h>
#include <contrecoup/gas/octree/leaf_box.h>

#include <algorithm>

namespace contrecoup::gas
{
namespace
{
  /// What tells leaves apart: corner and edge lengths.
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
void CutLeaves<dim>::reinit(const LeafMesh<dim> &mesh,
                            const LeafLayout &layout,
                            const RigidBody &body)
{
  mesh_ = &mesh;
  body_ = &body;
  layout_ = layout;
  measure_all();
  match_sizes();
  find_neighbors();
  choose_directions();
  share(directions_);
  find_neighborhoods();
  share(memberships_);
  classify_batches();
}


template <int dim>
void CutLeaves<dim>::measure_all()
{
  const unsigned int n_stored = mesh_->n_stored_batches() * mesh_->width();
  fractions_.reinit(n_stored, layout_.n_points);
  const bool is_plane = radial_exponent(mesh_->coarse_mesh().geometry()) == 0;
  radii_.assign(is_plane ? 0 : n_stored, {});
  shape_of_.assign(n_stored, open);
  matched_of_.assign(n_stored, open);
  matched_shapes_.clear();
  former_memory_ = std::move(memory_);
  memory_ = {};
  for (unsigned int leaf = 0; leaf < mesh_->n_owned(); ++leaf)
    measure(leaf_box(*mesh_, leaf), leaf);
  for (const auto &cell : mesh_->triangulation().active_cell_iterators())
    if (cell->is_ghost() && mesh_->leaf_of(cell) != no_leaf)
    {
      LeafBox<dim> box;
      box.origin = cell->vertex(0);
      box.extents = cell->vertex((1U << dim) - 1) - cell->vertex(0);
      measure(box, mesh_->leaf_of(cell));
    }
  former_memory_ = {};
}


template <int dim>
void CutLeaves<dim>::measure(const LeafBox<dim> &box, const unsigned int leaf)
{
  if (!radii_.empty())
    radii_[leaf] = {{box.origin[0], box.extents[0] / layout_.n}};
  const double radius =
    box.extents.norm() * (0.5 + 1. / layout_.n) * (1. + 1e-9);
  const double value =
    body_->value_in_leaf(dealii::Point<dim>(box.origin + box.extents * 0.5));
  if (value > radius)
    return;
  const int index = value < -radius ? closed : find_shape(box);
  if (index == closed)
    fractions_.close(leaf);
  if (index < 0)
    return;
  shape_of_[leaf] = index;
  fractions_.set(leaf, memory_.shapes[index].fraction);
}


template <int dim>
int CutLeaves<dim>::find_shape(const LeafBox<dim> &box)
{
  const Place place = place_of(box);
  int &index = memory_.index[place];
  index = static_cast<int>(memory_.shapes.size());
  const auto known = former_memory_.index.find(place);
  if (known == former_memory_.index.end())
  {
    Shape shape = treatment() == RigidBody::Treatment::embedded
                    ? cut_shape(box, layout_, *body_, !radii_.empty())
                    : staircase_shape(box, layout_, *body_);
    const auto &parts = shape.fraction;
    if (shape.is_open())
      return index = open;
    if (*std::max_element(parts.begin(), parts.end()) == 0.)
      return index = closed;
    memory_.shapes.push_back(std::move(shape));
    memory_.directions.emplace_back();
    memory_.sides.push_back(0);
    return index;
  }
  const int former = known->second;
  if (former < 0)
    return index = former;
  memory_.shapes.push_back(std::move(former_memory_.shapes[former]));
  memory_.directions.push_back(std::move(former_memory_.directions[former]));
  memory_.sides.push_back(former_memory_.sides[former]);
  return index;
}


template <int dim>
void CutLeaves<dim>::find_neighbors()
{
  neighbors_.clear();
  for (unsigned int leaf = 0; leaf < mesh_->n_owned(); ++leaf)
  {
    const unsigned int batch = leaf / mesh_->width();
    bool is_near = shape(leaf) != nullptr;
    for (unsigned int face = 0; face < 2 * dim; ++face)
      is_near =
        is_near || shape(mesh_->neighbors(batch, face)[leaf % mesh_->width()]);
    if (is_near)
      connect(leaf);
  }
}


template <int dim>
void CutLeaves<dim>::connect(const unsigned int leaf)
{
  const unsigned int batch = leaf / mesh_->width();
  const unsigned int lane = leaf % mesh_->width();
  std::array<unsigned int, 2 * dim> neighbors;
  for (unsigned int face = 0; face < 2 * dim; ++face)
    neighbors[face] = mesh_->neighbors(batch, face)[lane];
  for (auto s = mesh_->special_begin(batch); s != mesh_->special_end(batch);
       ++s)
    if (s->lane == lane)
      neighbors[s->face] = no_leaf;
  neighbors_[leaf] = neighbors;
  for (unsigned int face = 0; face < 2 * dim; ++face)
    if (neighbors[face] != no_leaf && neighbors[face] >= mesh_->first_ghost())
    {
      std::array<unsigned int, 2 * dim> none;
      none.fill(no_leaf);
      neighbors_.try_emplace(neighbors[face], none).first->second[face ^ 1U] =
        leaf;
    }
}


template <int dim>
unsigned int CutLeaves<dim>::line_of(const unsigned int point,
                                     const unsigned int d) const
{
  const unsigned int s = layout_.stride(d);
  return point % s + point / (s * layout_.n) * s;
}


template <int dim>
double CutLeaves<dim>::radius(const Cell &cell) const
{
  if (radii_.empty())
    return 1.;
  const auto &[inner, edge] = radii_[cell.leaf];
  return inner + (cell.point % layout_.n + 0.5) * edge;
}


template <int dim>
double CutLeaves<dim>::cell_volume(const Cell &cell) const
{
  double result = radii_.empty() ? 1. : 2. * dealii::numbers::PI * radius(cell);
  const auto extents = leaf_box(*mesh_, cell.leaf).extents;
  for (unsigned int d = 0; d < dim; ++d)
    result *= extents[d] / layout_.n;
  return result;
}


template <int dim>
double CutLeaves<dim>::opening(const Cell &cell, const unsigned int face) const
{
  const Shape *here = shape(cell.leaf);
  if (here == nullptr)
    return fractions_.is_open(cell.leaf) ? 1. : 0.;
  const unsigned int d = face / 2;
  const unsigned int layer =
    cell.point / layout_.stride(d) % layout_.n + face % 2;
  return here
    ->opening[d][layer * layout_.n_face_points + line_of(cell.point, d)];
}


template <int dim>
double CutLeaves<dim>::inner_opening_beyond(const unsigned int leaf,
                                            const unsigned int face,
                                            const unsigned int line) const
{
  const auto found = neighbors_.find(leaf);
  if (found == neighbors_.end() || found->second[face] == no_leaf)
    return 1.;
  return opening({found->second[face], layout_.face_point(face ^ 1U, line, 0)},
                 face);
}


template <int dim>
bool CutLeaves<dim>::reads_cut(const unsigned int leaf) const
{
  if (neighbors_.find(leaf) == neighbors_.end())
    return false;
  for (unsigned int face = 0; face < 2 * dim; ++face)
    for (unsigned int line = 0; line < layout_.n_face_points; ++line)
      if (inner_opening_beyond(leaf, face, line) == 0.)
        return true;
  return false;
}


template <int dim>
void CutLeaves<dim>::classify_batches()
{
  batch_kind_.assign(mesh_->n_batches(), BatchKind::open);
  for (unsigned int batch = 0; batch < mesh_->n_batches(); ++batch)
  {
    unsigned int n_closed = 0;
    bool is_cut = false;
    for (unsigned int lane = 0; lane < mesh_->n_filled_lanes(batch); ++lane)
    {
      const unsigned int leaf = batch * mesh_->width() + lane;
      if (fractions_.is_closed(leaf))
        ++n_closed;
      else
        is_cut = is_cut || shape(leaf) != nullptr || reads_cut(leaf) ||
                 memberships_.count(leaf) > 0;
    }
    if (n_closed == mesh_->n_filled_lanes(batch))
      batch_kind_[batch] = BatchKind::closed;
    else if (is_cut || n_closed > 0)
      batch_kind_[batch] = BatchKind::cut;
  }
}


template class CutLeaves<2>;
template class CutLeaves<3>;
} // namespace contrecoup::gas

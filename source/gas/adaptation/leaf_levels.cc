// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation/leaf_levels.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::gas
{
template <int dim>
bool LeafLevels<dim>::is_in_fine_box(const dealii::Point<dim> &place) const
{
  if (parameters_.fine_level == 0)
    return false;
  for (unsigned int d = 0; d < dim; ++d)
    if (place[d] < parameters_.fine_lower[d] ||
        place[d] > parameters_.fine_upper[d])
      return false;
  return true;
}


template <int dim>
SizeLimits::Levels LeafLevels<dim>::levels(const unsigned int leaf,
                                           const double time) const
{
  SizeLimits::Levels general = {parameters_.min_level, parameters_.max_level};
  if (body_ != nullptr)
  {
    const unsigned int level = body_level(leaf);
    const double layers = leaf_diagonals_from_body(leaf);
    if (layers <= RigidBody::max_diagonals_at_body)
      return {level, level};
    // Finer leaves next to those at the body would refine these by 2:1 balance.
    if (layers <= 2.)
      general.max_level = std::min(general.max_level, level + 2);
  }
  return narrowed(leaf, general, time);
}


template <int dim>
SizeLimits::Levels LeafLevels<dim>::narrowed(const unsigned int leaf,
                                             SizeLimits::Levels general,
                                             const double time) const
{
  const auto centre = mesh_.cell(leaf)->center();
  if (is_in_fine_box(centre))
    general.min_level = std::max(general.min_level, parameters_.fine_level);
  return parameters_.limits.levels(
    centre, time, general, 0.5 * mesh_.cell(leaf)->diameter());
}


template <int dim>
std::vector<double> LeafLevels<dim>::size_ratios(const double time) const
{
  std::vector<double> result(mesh_.n_owned());
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
  {
    const unsigned int level = mesh_.cell(leaf)->level();
    const unsigned int most = max_level(leaf, time);
    result[leaf] = std::pow(0.5, std::max(level, most) - most);
  }
  return result;
}


template <int dim>
unsigned int LeafLevels<dim>::max_level(const unsigned int leaf,
                                        const double time) const
{
  return narrowed(leaf, {parameters_.min_level, parameters_.max_level}, time)
    .max_level;
}


template <int dim>
unsigned int LeafLevels<dim>::min_level_near_body(const unsigned int leaf) const
{
  if (body_ == nullptr)
    return 0;
  const int finest = body_level(leaf);
  typename LeafMesh<dim>::CellIterator cell = mesh_.cell(leaf);
  for (; cell->level() > 0; cell = cell->parent())
  {
    const auto &parent = cell->parent();
    const int coarser = finest - parent->level();
    const double layers =
      body_->leaf_diagonals_to(parent->vertex(0),
                               parent->vertex((1U << dim) - 1),
                               parent->level() - int(initial_level_));
    // Leaf sizes double at most from one layer of leaves to the next; each size
    // between that at the body and that of the parent needs one layer.
    if (layers <= RigidBody::max_diagonals_at_body ||
        layers < (std::ldexp(1., coarser) - 2.) / std::sqrt(dim))
      break;
  }
  return cell->level();
}


template <int dim>
unsigned int LeafLevels<dim>::body_level(const unsigned int leaf) const
{
  const auto &cell = mesh_.cell(leaf);
  return initial_level_ +
         body_->levels(cell->vertex(0), cell->vertex((1U << dim) - 1));
}


template <int dim>
double LeafLevels<dim>::leaf_diagonals_from_body(const unsigned int leaf) const
{
  const auto &cell = mesh_.cell(leaf);
  return body_->leaf_diagonals_to(cell->vertex(0),
                                  cell->vertex((1U << dim) - 1),
                                  cell->level() - int(initial_level_));
}


template <int dim>
bool LeafLevels<dim>::is_too_coarse_at_body(const unsigned int leaf) const
{
  return body_ != nullptr &&
         static_cast<unsigned int>(mesh_.cell(leaf)->level()) <
           body_level(leaf) &&
         leaf_diagonals_from_body(leaf) <= RigidBody::max_diagonals_at_body;
}


template class LeafLevels<1>;
template class LeafLevels<2>;
template class LeafLevels<3>;
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation/adaptation.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::gas
{
template <int dim>
bool Adaptation<dim>::is_in_fine_box(const dealii::Point<dim> &place) const
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
SizeLimits::Levels Adaptation<dim>::levels(const unsigned int leaf) const
{
  SizeLimits::Levels general = {parameters_.least_level,
                                parameters_.most_level};
  if (body_ != nullptr)
  {
    const unsigned int level = body_level(leaf);
    const double layers = layers_from_body(leaf);
    if (layers <= RigidBody::at_body)
      return {level, level};
    // Finer ones beside those at the body would have them halved as well.
    if (layers <= 2.)
      general.most = std::min(general.most, level + 2);
  }
  return narrowed(leaf, general, time_);
}


template <int dim>
SizeLimits::Levels Adaptation<dim>::narrowed(const unsigned int leaf,
                                             SizeLimits::Levels general,
                                             const double time) const
{
  const auto centre = mesh_.cell(leaf)->center();
  if (is_in_fine_box(centre))
    general.least = std::max(general.least, parameters_.fine_level);
  return parameters_.limits.levels(
    centre, time, general, 0.5 * mesh_.cell(leaf)->diameter());
}


template <int dim>
std::vector<double> Adaptation<dim>::size_ratios(const double time) const
{
  std::vector<double> result(mesh_.n_owned());
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
  {
    const unsigned int level = mesh_.cell(leaf)->level();
    const unsigned int most =
      narrowed(leaf, {parameters_.least_level, parameters_.most_level}, time)
        .most;
    result[leaf] = std::pow(0.5, std::max(level, most) - most);
  }
  return result;
}


template <int dim>
unsigned int Adaptation<dim>::most_level(const unsigned int leaf,
                                         const double time) const
{
  return narrowed(leaf, {parameters_.least_level, parameters_.most_level}, time)
    .most;
}


template <int dim>
unsigned int
Adaptation<dim>::least_level_near_body(const unsigned int leaf) const
{
  if (body_ == nullptr)
    return 0;
  const int finest = body_level(leaf);
  CellIterator cell = mesh_.cell(leaf);
  for (; cell->level() > 0; cell = cell->parent())
  {
    const auto &parent = cell->parent();
    const int coarser = finest - parent->level();
    const double layers =
      body_->layers_to(parent->vertex(0),
                       parent->vertex((1U << dim) - 1),
                       parent->level() - int(initial_level_));
    // Leaves get twice as large at most from one layer to the next: between
    // those at the body and the parent each larger size has one layer.
    if (layers <= RigidBody::at_body ||
        layers < (std::ldexp(1., coarser) - 2.) / std::sqrt(dim))
      break;
  }
  return cell->level();
}


template <int dim>
unsigned int Adaptation<dim>::body_level(const unsigned int leaf) const
{
  const auto &cell = mesh_.cell(leaf);
  return initial_level_ +
         body_->levels(cell->vertex(0), cell->vertex((1U << dim) - 1));
}


template <int dim>
double Adaptation<dim>::layers_from_body(const unsigned int leaf) const
{
  const auto &cell = mesh_.cell(leaf);
  return body_->layers_to(cell->vertex(0),
                          cell->vertex((1U << dim) - 1),
                          cell->level() - int(initial_level_));
}


template <int dim>
void Adaptation<dim>::refine_at_body()
{
  do
    for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
      if (body_ != nullptr &&
          static_cast<unsigned int>(mesh_.cell(leaf)->level()) <
            body_level(leaf) &&
          layers_from_body(leaf) <= RigidBody::at_body)
        mesh_.cell(leaf)->set_refine_flag();
  while (refine_flagged());
}


template <int dim>
void Adaptation<dim>::refine_fine_box()
{
  do
    for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
      if (parameters_.fine_level > 0 &&
          static_cast<unsigned int>(mesh_.cell(leaf)->level()) <
            levels(leaf).least)
        mesh_.cell(leaf)->set_refine_flag();
  while (refine_flagged());
}


template class Adaptation<1>;
template class Adaptation<2>;
template class Adaptation<3>;
} // namespace contrecoup::gas

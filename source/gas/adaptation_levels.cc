// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation.h>

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
  const auto centre = mesh_.cell(leaf)->center();
  SizeLimits::Levels general = {parameters_.least_level,
                                parameters_.most_level};
  if (is_at_body(leaf))
    return {body_level_, body_level_};
  if (is_in_fine_box(centre))
    general.least = std::max(general.least, parameters_.fine_level);
  return parameters_.limits.levels(
    centre, time_, general, 0.5 * mesh_.cell(leaf)->diameter());
}


template <int dim>
bool Adaptation<dim>::is_at_body(const unsigned int leaf) const
{
  if (body_ == nullptr)
    return false;
  const auto &cell = mesh_.cell(leaf);
  const double diagonal =
    (cell->vertex((1U << dim) - 1) - cell->vertex(0)).norm();
  const double wanted = std::ldexp(diagonal, cell->level() - int(body_level_));
  return std::abs(body_->value(cell->center())) <=
         (0.5 * diagonal + wanted) * (1. + 1e-9);
}


template <int dim>
void Adaptation<dim>::refine_at_body()
{
  do
    for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
      if (is_at_body(leaf) &&
          static_cast<unsigned int>(mesh_.cell(leaf)->level()) < body_level_)
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

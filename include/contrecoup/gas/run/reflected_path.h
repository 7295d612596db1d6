// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

namespace contrecoup::gas
{
/// Shortest way of a wave from its source by one side of a box, taken as a
/// mirror, to a gauge.
template <int dim>
struct ReflectedPath
{
  unsigned int side;
  dealii::Point<dim> image; ///< of the source behind the side [m]
  dealii::Point<dim> gauge; ///< that the way leads to [m]
  double length;            ///< of the whole way [m]
  double to_side;           ///< from the source straight to the side [m]
};


/// The shortest way by each of the @p sides, in the order of their lengths.
/// @param lower, upper corners of the box [m]
/// @param nearest gives the place of a gauge that is nearest to a place [m]
template <int dim>
std::vector<ReflectedPath<dim>> reflected_paths(
  const dealii::Point<dim> &source,
  const dealii::Point<dim> &lower,
  const dealii::Point<dim> &upper,
  const std::vector<unsigned int> &sides,
  const std::function<dealii::Point<dim>(const dealii::Point<dim> &)> &nearest);
} // namespace contrecoup::gas

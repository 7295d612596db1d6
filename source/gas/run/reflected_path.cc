// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/run/reflected_path.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::gas
{
template <int dim>
std::vector<ReflectedPath<dim>> reflected_paths(
  const dealii::Point<dim> &source,
  const dealii::Point<dim> &lower,
  const dealii::Point<dim> &upper,
  const std::vector<unsigned int> &sides,
  const std::function<dealii::Point<dim>(const dealii::Point<dim> &)> &nearest)
{
  std::vector<ReflectedPath<dim>> paths;
  for (const unsigned int side : sides)
  {
    const unsigned int d = side / 2;
    const double place = side % 2 == 0 ? lower[d] : upper[d];
    dealii::Point<dim> image = source;
    image[d] = 2. * place - source[d];
    const dealii::Point<dim> gauge = nearest(image);
    paths.push_back(
      {side, image, gauge, image.distance(gauge), std::abs(place - source[d])});
  }
  std::stable_sort(
    paths.begin(), paths.end(), [](const auto &first, const auto &second) {
      return first.length < second.length;
    });
  return paths;
}


#define CONTRECOUP_INSTANTIATE(dim)                         \
  template std::vector<ReflectedPath<dim>> reflected_paths( \
    const dealii::Point<dim> &,                             \
    const dealii::Point<dim> &,                             \
    const dealii::Point<dim> &,                             \
    const std::vector<unsigned int> &,                      \
    const std::function<dealii::Point<dim>(const dealii::Point<dim> &)> &)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);

#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/mesh/ghost_cells.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/grid_tools.h>

#include <array>
#include <vector>

namespace contrecoup
{
template <int dim, typename Data>
void exchange_with_ghosts(
  const dealii::Triangulation<dim> &mesh,
  const std::function<std::optional<Data>(
    const typename dealii::Triangulation<dim>::active_cell_iterator &)> &pack,
  const std::function<
    void(const typename dealii::Triangulation<dim>::active_cell_iterator &,
         const Data &)> &unpack)
{
  dealii::GridTools::exchange_cell_data_to_ghosts<Data,
                                                  dealii::Triangulation<dim>>(
    mesh, pack, unpack);
}


#define CONTRECOUP_INSTANTIATE(dim, ...)                            \
  template void exchange_with_ghosts<dim, __VA_ARGS__>(             \
    const dealii::Triangulation<dim> &,                             \
    const std::function<std::optional<__VA_ARGS__>(                 \
      const dealii::Triangulation<dim>::active_cell_iterator &)> &, \
    const std::function<void(                                       \
      const dealii::Triangulation<dim>::active_cell_iterator &,     \
      const __VA_ARGS__ &)> &)
#define CONTRECOUP_INSTANTIATE_ALL(dim)                                     \
  CONTRECOUP_INSTANTIATE(dim, std::array<double, 2 * dim>);                 \
  CONTRECOUP_INSTANTIATE(dim, std::array<dealii::Point<dim>, (1U << dim)>); \
  CONTRECOUP_INSTANTIATE(dim, std::vector<unsigned char>);                  \
  CONTRECOUP_INSTANTIATE(dim, std::vector<std::vector<double>>)

CONTRECOUP_INSTANTIATE_ALL(2);
CONTRECOUP_INSTANTIATE_ALL(3);
#undef CONTRECOUP_INSTANTIATE_ALL
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup

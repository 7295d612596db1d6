// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/grid/tria.h>

#include <functional>
#include <optional>

namespace contrecoup
{
/// Sends what @p pack gives for each cell, unless that is empty, to the ranks
/// that have the cell as a ghost, where @p unpack takes it. This function calls
/// dealii::GridTools::exchange_cell_data_to_ghosts(), whose header makes each
/// source that reads it compile for nine seconds more.
/// @tparam Data one of the types that ghost_cells.cc instantiates
template <int dim, typename Data>
void exchange_with_ghosts(
  const dealii::Triangulation<dim> &mesh,
  const std::function<std::optional<Data>(
    const typename dealii::Triangulation<dim>::active_cell_iterator &)> &pack,
  const std::function<
    void(const typename dealii::Triangulation<dim>::active_cell_iterator &,
         const Data &)> &unpack);
} // namespace contrecoup

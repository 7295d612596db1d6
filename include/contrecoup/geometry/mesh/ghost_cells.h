// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/grid/tria.h>

#include <functional>
#include <optional>

namespace contrecoup
{
/// Sends @p pack of each cell, unless it is empty, to the ranks that have the
/// cell as a ghost, for @p unpack. It is
/// dealii::GridTools::exchange_cell_data_to_ghosts(), whose header takes each
/// source that reads it nine seconds to compile. Data: those in the source.
template <int dim, typename Data>
void exchange_with_ghosts(
  const dealii::Triangulation<dim> &mesh,
  const std::function<std::optional<Data>(
    const typename dealii::Triangulation<dim>::active_cell_iterator &)> &pack,
  const std::function<
    void(const typename dealii::Triangulation<dim>::active_cell_iterator &,
         const Data &)> &unpack);
} // namespace contrecoup

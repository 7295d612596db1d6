// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/deal_ii/releases.h>
#include <contrecoup/gas/octree/hanging_vertices.h>
#include <contrecoup/gas/octree/leaf_face.h>
#include <contrecoup/geometry/mesh/ghost_cells.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <optional>

namespace contrecoup::gas
{
template <int dim>
HangingVertices<dim>::HangingVertices(Tria &triangulation)
  : triangulation_(triangulation)
  , before_refinement_(triangulation.signals.pre_distributed_refinement.connect(
      [this]() { restore(); }))
  , before_repartition_(
      triangulation.signals.pre_distributed_repartition.connect(
        [this]() { restore(); }))
  , at_creation_(
      triangulation.signals.create.connect([this]() { before_.clear(); }))
{}


template <int dim>
void HangingVertices<dim>::settle()
{
  restore();
  const unsigned int n_levels = triangulation_.n_global_levels();
  bool any = false;
  for (const auto &cell : triangulation_.active_cell_iterators())
    any = any || static_cast<unsigned int>(cell->level()) + 1 < n_levels;
  if (dealii::Utilities::MPI::max(any ? 1U : 0U,
                                  communicator_of(triangulation_)) == 0)
    return;
  before_ = triangulation_.get_vertices();
  // A vertex that hangs on a coarse leaf may be the end of a finer leaf's edge
  // on which others hang.
  for (unsigned int level = 0; level + 1 < n_levels; ++level)
  {
    settle_level(level);
    exchange_vertices();
  }
}


template <int dim>
void HangingVertices<dim>::settle_level(const unsigned int level)
{
  if (level >= triangulation_.n_levels())
    return;
  for (const auto &cell : triangulation_.active_cell_iterators_on_level(level))
  {
    if (cell->is_artificial())
      continue;
    for (const unsigned int l : cell->line_indices())
    {
      const auto line = cell->line(l);
      if (line->has_children())
        line->child(0)->vertex(1) = (line->vertex(0) + line->vertex(1)) * 0.5;
    }
    if constexpr (dim == 3)
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->has_children())
        {
          dealii::Point<dim> sum;
          for (unsigned int corner = 0; corner < 4; ++corner)
            sum += cell->vertex(face_corner<dim>(f, corner % 2, corner / 2));
          cell->face(f)->child(0)->vertex(3) = sum * 0.25;
        }
  }
}


// From owned leaves to their ghosts on other ranks, which do not see all that
// the ghosts' far vertices hang on.
template <int dim>
void HangingVertices<dim>::exchange_vertices()
{
  using Cell = typename Tria::active_cell_iterator;
  using Vertices = std::array<dealii::Point<dim>, (1U << dim)>;
  const auto pack = [](const Cell &cell) {
    Vertices vertices;
    for (const unsigned int v : cell->vertex_indices())
      vertices[v] = cell->vertex(v);
    return std::optional<Vertices>(vertices);
  };
  const auto unpack = [](const Cell &cell, const Vertices &vertices) {
    for (const unsigned int v : cell->vertex_indices())
      cell->vertex(v) = vertices[v];
  };
  exchange_with_ghosts<dim, Vertices>(triangulation_, pack, unpack);
}


template <int dim>
void HangingVertices<dim>::restore()
{
  if (before_.empty())
    return;
  for (const auto &cell : triangulation_.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      cell->vertex(v) = before_[cell->vertex_index(v)];
  before_.clear();
}


template class HangingVertices<2>;
template class HangingVertices<3>;
} // namespace contrecoup::gas

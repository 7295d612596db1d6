// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/mesh/mesh_pieces.h>

namespace contrecoup
{
template <int dim>
std::vector<unsigned int> find_pieces(const dealii::Triangulation<dim> &mesh)
{
  constexpr unsigned int none = -1;
  std::vector<unsigned int> piece(mesh.n_cells(), none);
  std::vector<typename dealii::Triangulation<dim>::active_cell_iterator> next;
  unsigned int n_pieces = 0;
  for (const auto &first : mesh.active_cell_iterators())
  {
    if (piece[first->index()] != none)
      continue;
    piece[first->index()] = n_pieces;
    next.push_back(first);
    while (!next.empty())
    {
      const auto cell = next.back();
      next.pop_back();
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f) && piece[cell->neighbor(f)->index()] == none)
        {
          piece[cell->neighbor(f)->index()] = n_pieces;
          next.push_back(cell->neighbor(f));
        }
    }
    ++n_pieces;
  }
  return piece;
}


std::string pieces_warning(const std::string &what, const unsigned int n_pieces)
{
  if (n_pieces < 2)
    return "";
  return "WARNING: " + what + " is in " + std::to_string(n_pieces) +
         " pieces that share no face; nothing passes from one to the other";
}


template std::vector<unsigned int>
find_pieces(const dealii::Triangulation<1> &);
template std::vector<unsigned int>
find_pieces(const dealii::Triangulation<2> &);
template std::vector<unsigned int>
find_pieces(const dealii::Triangulation<3> &);
} // namespace contrecoup

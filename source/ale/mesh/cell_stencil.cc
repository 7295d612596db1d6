// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/cell_stencil.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <algorithm>

namespace contrecoup::ale
{
namespace
{
  /// Concatenates lists, with the index of the first entry of each.
  void join_lists(const std::vector<std::vector<std::uint32_t>> &lists,
                  std::vector<std::uint32_t> &first,
                  std::vector<std::uint32_t> &values)
  {
    first.assign(1, 0);
    values.clear();
    for (const auto &list : lists)
    {
      values.insert(values.end(), list.begin(), list.end());
      first.push_back(static_cast<std::uint32_t>(values.size()));
    }
  }

  bool is_wall(const HexSpace &space, const HexSpace::Face &face)
  {
    return face.outside == HexSpace::no_cell ||
           space.region(face.inside) != space.region(face.outside);
  }

  /// Local number of the face in the cell.
  unsigned int face_number(const HexSpace::Cell &cell,
                           const HexSpace::Face &face)
  {
    for (unsigned int f = 0; f < 6; ++f)
      if (std::all_of(std::begin(hex_faces[f]),
                      std::end(hex_faces[f]),
                      [&](const unsigned int corner) {
                        return std::find(face.nodes.begin(),
                                         face.nodes.end(),
                                         cell[corner]) != face.nodes.end();
                      }))
        return f;
    return 6;
  }
} // namespace


void CellStencil::reinit(const HexSpace &space)
{
  find_neighbors(space);
  find_inside(space);
  find_faces(space);
}


void CellStencil::find_neighbors(const HexSpace &space)
{
  Lists lists(space.n_locally_owned_cells());
  for (std::uint32_t c = 0; c < lists.size(); ++c)
    for (const std::uint32_t node : space.cell(c))
      for (const std::uint32_t other : space.cells_around(node))
        if (other != c && space.region(other) == space.region(c) &&
            std::find(lists[c].begin(), lists[c].end(), other) ==
              lists[c].end())
          lists[c].push_back(other);
  join_lists(lists, first_neighbor_, neighbors_);
}


void CellStencil::find_inside(const HexSpace &space)
{
  FieldExchange exchange;
  exchange.reinit(space.nodes(), 1);
  dealii::AlignedVector<double> n_walls(exchange.size());
  for (const HexSpace::Face &face : space.faces())
    if (is_wall(space, face))
      for (const std::uint32_t node : face.nodes)
        n_walls[node] += 1.;
  exchange.compress_add(n_walls);
  exchange.update_ghost_values(n_walls);
  for (const auto &[sliding, held] : space.sliding_pairs())
    n_walls[sliding] = n_walls[held] = n_walls[sliding] + n_walls[held];
  is_inside_.clear();
  for (const double n : n_walls)
    is_inside_.push_back(n == 0. ? 1 : 0);
}


void CellStencil::find_faces(const HexSpace &space)
{
  Lists faces(space.n_locally_owned_cells()),
    opposite(space.n_locally_owned_cells());
  // Neighbour across each face of owned cells; no_cell at walls.
  std::vector<std::array<std::uint32_t, 6>> across(
    space.n_locally_owned_cells());
  for (auto &cells : across)
    cells.fill(HexSpace::no_cell);
  for (std::uint32_t f = 0; f < space.faces().size(); ++f)
  {
    const HexSpace::Face &face = space.faces()[f];
    if (is_wall(space, face))
      continue;
    for (const auto &[cell, other] :
         {std::make_pair(face.inside, face.outside),
          std::make_pair(face.outside, face.inside)})
      if (cell < space.n_locally_owned_cells())
      {
        faces[cell].push_back(f);
        across[cell][face_number(space.cell(cell), face)] = other;
      }
  }
  for (std::size_t c = 0; c < across.size(); ++c)
    for (unsigned int f = 0; f < 6; ++f)
      if (across[c][f] != HexSpace::no_cell &&
          across[c][f ^ 1U] == HexSpace::no_cell)
        opposite[c].push_back(across[c][f]);
  join_lists(faces, first_face_, faces_);
  join_lists(opposite, first_opposite_, opposite_);
}
} // namespace contrecoup::ale

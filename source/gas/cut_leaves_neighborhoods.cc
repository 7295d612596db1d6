// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/cut_leaves.h>
#include <contrecoup/gas/gas_measures.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <optional>

namespace contrecoup::gas
{
template <int dim>
typename CutLeaves<dim>::Cell
CutLeaves<dim>::next(const Cell &cell, const unsigned int face) const
{
  if (opening(cell, face) == 0.)
    return {};
  const unsigned int d = face / 2;
  const unsigned int s = layout_.stride(d);
  const unsigned int i = cell.point / s % layout_.n;
  if (face % 2 == 1 && i + 1 < layout_.n)
    return {cell.leaf, cell.point + s};
  if (face % 2 == 0 && i > 0)
    return {cell.leaf, cell.point - s};
  const auto found = neighbors_.find(cell.leaf);
  if (found == neighbors_.end() || found->second[face] == no_leaf)
    return {};
  return {found->second[face],
          layout_.face_point(face ^ 1U, line_of(cell.point, d), 0)};
}


template <int dim>
unsigned char CutLeaves<dim>::choose_direction(const Cell &cell) const
{
  const double enough = 0.5;
  const auto extents = leaf_box(*mesh_, cell.leaf).extents;
  std::array<std::pair<double, unsigned int>, 2 * dim> faces;
  for (unsigned int d = 0; d < dim; ++d)
  {
    const double wall =
      (opening(cell, 2 * d) - opening(cell, 2 * d + 1)) / extents[d];
    faces[2 * d] = {-wall, 2 * d};
    faces[2 * d + 1] = {wall, 2 * d + 1};
  }
  // From the most away from the wall to the most towards it.
  std::sort(faces.begin(), faces.end());
  unsigned char best = 0;
  double largest = fractions_(cell.leaf, cell.point);
  for (const bool any_direction : {false, true})
    for (unsigned int length = 1; length <= 2; ++length)
      for (const auto &[towards, face] : faces)
      {
        if (towards >= 0. && !any_direction)
          continue;
        double volume = fractions_(cell.leaf, cell.point);
        Cell other = cell;
        unsigned int n_steps = 0;
        for (; n_steps < length; ++n_steps)
        {
          other = next(other, face);
          if (other.leaf == no_leaf)
            break;
          volume += fractions_(other.leaf, other.point);
        }
        if (n_steps == length && volume > largest)
        {
          largest = volume;
          best = 1 + face + 2 * dim * (length - 1);
        }
        if (largest >= enough)
          return best;
      }
  return best;
}


template <int dim>
void CutLeaves<dim>::choose_directions()
{
  directions_.clear();
  for (unsigned int leaf = 0; leaf < mesh_->n_owned(); ++leaf)
    if (shape(leaf) != nullptr)
    {
      Codes codes(layout_.n_points, 0);
      for (unsigned int q = 0; q < layout_.n_points; ++q)
        if (const double part = fractions_(leaf, q); part > 0. && part < 0.5)
          codes[q] = choose_direction({leaf, q});
      if (std::any_of(codes.begin(), codes.end(), [](const unsigned char c) {
            return c != 0;
          }))
        directions_[leaf] = codes;
    }
}


template <int dim>
void CutLeaves<dim>::find_neighborhoods()
{
  neighborhoods_.clear();
  memberships_.clear();
  for (const auto &[leaf, codes] : directions_)
    for (unsigned int q = 0; q < layout_.n_points; ++q)
      if (codes[q] != 0)
      {
        const unsigned int face = (codes[q] - 1) % (2 * dim);
        const unsigned int length = 1 + (codes[q] - 1) / (2 * dim);
        Neighborhood neighborhood{face, {{leaf, q}}};
        bool is_needed = leaf < mesh_->n_owned();
        for (unsigned int i = 0; i < length; ++i)
        {
          const Cell other = next(neighborhood.cells.back(), face);
          if (other.leaf == no_leaf)
            break;
          neighborhood.cells.push_back(other);
          if (other.leaf < mesh_->n_owned())
          {
            is_needed = true;
            Codes &members = memberships_[other.leaf];
            members.resize(layout_.n_points, 0);
            ++members[other.point];
          }
        }
        if (is_needed)
          neighborhoods_.push_back(neighborhood);
      }
}


template <int dim>
unsigned int CutLeaves<dim>::n_memberships(const Cell &cell) const
{
  const auto found = memberships_.find(cell.leaf);
  return 1 + (found == memberships_.end() ? 0 : found->second[cell.point]);
}


template <int dim>
void CutLeaves<dim>::share(std::map<unsigned int, Codes> &codes) const
{
  using Iterator = typename dealii::Triangulation<dim>::active_cell_iterator;
  if (dealii::Utilities::MPI::n_mpi_processes(mesh_->communicator()) == 1)
    return;
  const auto pack = [&](const Iterator &cell) -> std::optional<Codes> {
    const auto found = codes.find(mesh_->leaf_of(cell));
    if (found == codes.end())
      return {};
    return found->second;
  };
  std::map<unsigned int, Codes> received;
  const auto unpack = [&](const Iterator &cell, const Codes &values) {
    if (mesh_->leaf_of(cell) != no_leaf)
      received[mesh_->leaf_of(cell)] = values;
  };
  dealii::GridTools::exchange_cell_data_to_ghosts<Codes,
                                                  dealii::Triangulation<dim>>(
    mesh_->triangulation(), pack, unpack);
  codes.insert(received.begin(), received.end());
}


template class CutLeaves<2>;
template class CutLeaves<3>;
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/cut_leaves.h>
#include <contrecoup/gas/octree/leaf_box.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace contrecoup::gas
{
namespace
{
  /// Area of what surrounds a chain of cells across a face, walls and open
  /// faces, in parts of a face of its first cell.
  template <int dim>
  double surface(const CutLeaves<dim> &leaves,
                 const typename CutLeaves<dim>::Chain &chain,
                 const unsigned int face)
  {
    double result = 0.;
    for (const auto &cell : chain)
    {
      const double scale = std::pow(cell.size, (dim - 1.) / dim);
      double area = leaves.wall(cell).norm();
      for (unsigned int f = 0; f < 2 * dim; ++f)
        area += leaves.opening(cell, f);
      // Each but the first shares a face with the one before.
      if (&cell != &chain.front())
        area -= 2. * leaves.opening(cell, face ^ 1U);
      result += scale * area;
    }
    return result;
  }
} // namespace


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
bool CutLeaves<dim>::cross(const unsigned int face, Chain &chain) const
{
  const Cell cell = chain.back();
  const unsigned int d = face / 2;
  const auto found = sides_.find({cell.leaf, face});
  if (cell.point / layout_.stride(d) % layout_.n !=
        (face % 2) * (layout_.n - 1) ||
      found == sides_.end())
    return false;
  const auto &hanging = mesh_->hanging_faces()[found->second.first];
  const unsigned int n_fine = HangingFace<dim>::n_fine;
  const unsigned int line = line_of(cell.point, d);
  const std::size_t former = chain.size();
  if (const unsigned int part = found->second.second; part != no_leaf)
  {
    if (hanging_opening(hanging, part, line) > 0.)
      chain.push_back(
        {hanging.coarse_leaf,
         layout_.face_point(face ^ 1U, coarse_face_point(part, line), 0),
         double(2 * n_fine)});
    return chain.size() > former;
  }
  for (unsigned int part = 0; part < n_fine; ++part)
    for (unsigned int q = 0; q < layout_.n_face_points; ++q)
      if (hanging.fine_leaf[part] != no_leaf &&
          coarse_face_point(part, q) == line &&
          hanging_opening(hanging, part, q) > 0.)
        chain.push_back({hanging.fine_leaf[part],
                         layout_.face_point(face ^ 1U, q, 0),
                         0.5 / n_fine});
  return chain.size() > former;
}


template <int dim>
typename CutLeaves<dim>::Chain
CutLeaves<dim>::chain(const Cell &cell,
                      const unsigned int face,
                      const unsigned int length) const
{
  Chain result(1, cell);
  for (unsigned int i = 1; i <= length; ++i)
  {
    const Cell other = next(result.back(), face);
    if (other.leaf != no_leaf)
      result.push_back(other);
    else if (i != length || !cross(face, result))
      return {};
  }
  for (Cell &other : result)
    other.size *= radius(other) / radius(cell);
  return result;
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
  const auto search = [&]() {
    for (const bool any_direction : {false, true})
      for (unsigned int length = 1; length <= 2; ++length)
        for (const auto &[towards, face] : faces)
        {
          if (towards >= 0. && !any_direction)
            continue;
          double volume = 0.;
          for (const Cell &other : chain(cell, face, length))
            volume += fractions_(other.leaf, other.point) * other.size;
          if (volume > largest)
          {
            largest = volume;
            best = 1 + face + 2 * dim * (length - 1);
          }
          if (largest >= enough)
            return;
        }
  };
  search();
  // Waves between walls that are too close need shorter steps: a cell that is
  // half open has a surface of (dim + 1) / 0.5.
  const double least = 0.25, most_surface = 4. * dim;
  const unsigned int face = best == 0 ? 0 : (best - 1) % (2 * dim);
  const Chain cells =
    best == 0 ? Chain(1, cell) : chain(cell, face, 1 + (best - 1) / (2 * dim));
  return largest < least || surface(*this, cells, face) > most_surface * largest
           ? pocket
           : best;
}


template <int dim>
unsigned int CutLeaves<dim>::kinds_of_sides(const unsigned int leaf) const
{
  const auto &neighbors = neighbors_.at(leaf);
  // The first bit tells it from what was never found.
  unsigned int result = 1;
  for (unsigned int face = 0; face < 2 * dim; ++face)
  {
    result *= 4;
    if (neighbors[face] != no_leaf)
      result += 1;
    else if (const auto side = sides_.find({leaf, face}); side != sides_.end())
      result += side->second.second == no_leaf ? 2 : 3;
  }
  return result;
}


template <int dim>
void CutLeaves<dim>::choose_in_leaf(const unsigned int leaf, Codes &codes) const
{
  codes.resize(layout_.n_points, 0);
  for (unsigned int q = 0; q < layout_.n_points; ++q)
    if (codes[q] != pocket)
    {
      const double part = fractions_(leaf, q);
      codes[q] = part > 0. && part < 0.5 ? choose_direction({leaf, q}) : 0;
    }
}


template <int dim>
void CutLeaves<dim>::choose_directions()
{
  directions_.clear();
  std::vector<unsigned int> new_leaves;
  for (unsigned int leaf = 0; leaf < mesh_->n_owned(); ++leaf)
  {
    // Others have no small cells.
    const int index = shape_of_[leaf];
    if (index < 0)
      continue;
    if (memory_.sides[index] == kinds_of_sides(leaf))
      directions_[leaf] = memory_.directions[index];
    else
      new_leaves.push_back(leaf);
  }
  close_pockets(directions_);
  // What is closed may make pockets of what is next to it.
  const unsigned int most_rounds = 10;
  for (unsigned int round = 0; round < most_rounds; ++round)
  {
    unsigned int n_pockets = 0;
    std::map<unsigned int, Codes> pockets;
    for (const unsigned int leaf : new_leaves)
    {
      Codes &codes = directions_[leaf];
      const auto before = std::count(codes.begin(), codes.end(), pocket);
      choose_in_leaf(leaf, codes);
      const auto now = std::count(codes.begin(), codes.end(), pocket);
      n_pockets += now - before;
      if (now > before)
        pockets[leaf] = codes;
    }
    if (dealii::Utilities::MPI::max(n_pockets, mesh_->communicator()) == 0)
      break;
    close_pockets(pockets);
  }
  for (const unsigned int leaf : new_leaves)
  {
    memory_.directions[shape_of_[leaf]] = directions_[leaf];
    memory_.sides[shape_of_[leaf]] = kinds_of_sides(leaf);
  }
}


template <int dim>
void CutLeaves<dim>::close_pockets(std::map<unsigned int, Codes> pockets)
{
  share(pockets);
  for (const auto &[leaf, codes] : pockets)
  {
    if (std::find(codes.begin(), codes.end(), pocket) == codes.end())
      continue;
    for (unsigned int q = 0; q < layout_.n_points; ++q)
      if (codes[q] == pocket)
        close({leaf, q});
    fractions_.set(leaf, own_shape(leaf).fraction);
  }
  match_cut_faces();
}


template <int dim>
void CutLeaves<dim>::close(const Cell &cell)
{
  own_shape(cell.leaf).fraction[cell.point] = 0.;
  for (unsigned int face = 0; face < 2 * dim; ++face)
  {
    const unsigned int d = face / 2;
    const unsigned int line = line_of(cell.point, d);
    const unsigned int layer =
      cell.point / layout_.stride(d) % layout_.n + face % 2;
    own_shape(cell.leaf).opening[d][layer * layout_.n_face_points + line] = 0.;
    if (layer != (face % 2) * layout_.n)
      continue;
    const auto found = neighbors_.find(cell.leaf);
    if (found == neighbors_.end())
      continue;
    const unsigned int other = found->second[face];
    if (other != no_leaf && !fractions_.is_closed(other))
      own_shape(other)
        .opening[d][(layout_.n - layer) * layout_.n_face_points + line] = 0.;
  }
}


template <int dim>
void CutLeaves<dim>::find_neighborhoods()
{
  neighborhoods_.clear();
  memberships_.clear();
  for (const auto &[leaf, codes] : directions_)
    for (unsigned int q = 0; q < layout_.n_points; ++q)
      if (codes[q] != 0 && codes[q] != pocket)
      {
        const unsigned int face = (codes[q] - 1) % (2 * dim);
        const unsigned int length = 1 + (codes[q] - 1) / (2 * dim);
        const Neighborhood neighborhood{face, chain({leaf, q}, face, length)};
        bool is_needed = false;
        for (const Cell &cell : neighborhood.cells)
          if (cell.leaf < mesh_->n_owned())
          {
            is_needed = true;
            if (cell.size == 1. && cell.leaf == leaf && cell.point == q)
              continue;
            Codes &members = memberships_[cell.leaf];
            members.resize(layout_.n_points, 0);
            ++members[cell.point];
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

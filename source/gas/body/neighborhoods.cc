// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/neighborhoods.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/geometry/mesh/ghost_cells.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace contrecoup::gas
{
namespace
{
  /// Whether the face of an owned cell is on a side of the domain.
  template <int dim>
  bool is_at_side(const CutShapes<dim> &shapes,
                  const FaceMatching<dim> &matching,
                  const Subcell &cell,
                  const unsigned int face)
  {
    return shapes.layer_of(cell, face) == face % 2 * shapes.layout().n &&
           matching.neighbor(cell.leaf, face) == no_leaf &&
           matching.hanging_side(cell.leaf, face) == nullptr;
  }


  /// Rate, in parts of sound speed over edge of the first cell, at which waves
  /// from walls and neighbours damp a uniform motion of a chain across @p face,
  /// in the direction where it is largest. Walls, and sides of the domain
  /// next to the first cell, count fully (impedance: density times sound
  /// speed), open faces half.
  template <int dim>
  double damping_rate(const CutShapes<dim> &shapes,
                      const FaceMatching<dim> &matching,
                      const typename Neighborhoods<dim>::Chain &chain,
                      const unsigned int face)
  {
    dealii::Tensor<1, dim> area;
    double volume = 0.;
    for (const Subcell &cell : chain)
    {
      const double scale = std::pow(cell.size, (dim - 1.) / dim);
      const auto wall = shapes.wall(cell);
      volume += shapes.fractions()(cell.leaf, cell.point) * cell.size;
      for (unsigned int d = 0; d < dim; ++d)
      {
        if (wall[d] != 0.)
          area[d] += scale * wall[d] * wall[d] / wall.norm();
        for (const unsigned int f : {2 * d, 2 * d + 1})
          area[d] +=
            scale * shapes.opening(cell, f) *
            (is_at_side(shapes, matching, chain.front(), f) ? 1. : 0.5);
      }
      // Each but the first shares a face with the one before.
      if (&cell != &chain.front())
        area[face / 2] -= scale * shapes.opening(cell, face ^ 1U);
    }
    double largest = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      largest = std::max(largest, area[d]);
    return largest / volume;
  }
} // namespace


template <int dim>
void Neighborhoods<dim>::reinit()
{
  choose_directions();
  share(directions_);
  find_neighborhoods();
  share(memberships_);
}


template <int dim>
Subcell Neighborhoods<dim>::next(const Subcell &cell,
                                 const unsigned int face) const
{
  if (shapes_.opening(cell, face) == 0.)
    return {};
  const unsigned int d = face / 2;
  const unsigned int s = layout().stride(d);
  const unsigned int i = cell.point / s % layout().n;
  if (face % 2 == 1 && i + 1 < layout().n)
    return {cell.leaf, cell.point + s};
  if (face % 2 == 0 && i > 0)
    return {cell.leaf, cell.point - s};
  const unsigned int other = matching_.neighbor(cell.leaf, face);
  if (other == no_leaf)
    return {};
  return {other,
          layout().face_point(face ^ 1U, shapes_.line_of(cell.point, d), 0)};
}


template <int dim>
bool Neighborhoods<dim>::cross(const unsigned int face, Chain &chain) const
{
  const Subcell cell = chain.back();
  const unsigned int d = face / 2;
  const auto *side = matching_.hanging_side(cell.leaf, face);
  if (cell.point / layout().stride(d) % layout().n !=
        (face % 2) * (layout().n - 1) ||
      side == nullptr)
    return false;
  const auto &hanging = shapes_.mesh().hanging_faces()[side->first];
  const unsigned int n_fine = HangingFace<dim>::n_fine;
  const unsigned int line = shapes_.line_of(cell.point, d);
  const std::size_t former = chain.size();
  if (const unsigned int part = side->second; part != no_leaf)
  {
    if (matching_.hanging_opening(hanging, part, line) > 0.)
      chain.push_back({hanging.coarse_leaf,
                       layout().face_point(
                         face ^ 1U, matching_.coarse_face_point(part, line), 0),
                       double(2 * n_fine)});
    return chain.size() > former;
  }
  for (unsigned int part = 0; part < n_fine; ++part)
    for (unsigned int q = 0; q < layout().n_face_points; ++q)
      if (hanging.fine_leaf[part] != no_leaf &&
          matching_.coarse_face_point(part, q) == line &&
          matching_.hanging_opening(hanging, part, q) > 0.)
        chain.push_back({hanging.fine_leaf[part],
                         layout().face_point(face ^ 1U, q, 0),
                         0.5 / n_fine});
  return chain.size() > former;
}


template <int dim>
typename Neighborhoods<dim>::Chain
Neighborhoods<dim>::chain(const Subcell &cell,
                          const unsigned int face,
                          const unsigned int length) const
{
  Chain result(1, cell);
  for (unsigned int i = 1; i <= length; ++i)
  {
    const Subcell other = next(result.back(), face);
    if (other.leaf != no_leaf)
      result.push_back(other);
    else if (i != length || !cross(face, result))
      return {};
  }
  for (Subcell &other : result)
    other.size *= shapes_.radius(other) / shapes_.radius(cell);
  return result;
}


template <int dim>
double Neighborhoods<dim>::surface(const Chain &chain,
                                   const unsigned int face) const
{
  double result = 0.;
  for (const Subcell &cell : chain)
  {
    const double scale = std::pow(cell.size, (dim - 1.) / dim);
    double area = shapes_.wall(cell).norm();
    for (unsigned int f = 0; f < 2 * dim; ++f)
      area += shapes_.opening(cell, f);
    // Each but the first shares a face with the one before.
    if (&cell != &chain.front())
      area -= 2. * shapes_.opening(cell, face ^ 1U);
    result += scale * area;
  }
  return result;
}


template <int dim>
unsigned char Neighborhoods<dim>::choose_direction(const Subcell &cell) const
{
  const double enough = 0.5;
  const auto extents = leaf_box(shapes_.mesh(), cell.leaf).extents;
  std::array<std::pair<double, unsigned int>, 2 * dim> faces;
  for (unsigned int d = 0; d < dim; ++d)
  {
    const double wall =
      (shapes_.opening(cell, 2 * d) - shapes_.opening(cell, 2 * d + 1)) /
      extents[d];
    faces[2 * d] = {-wall, 2 * d};
    faces[2 * d + 1] = {wall, 2 * d + 1};
  }
  // From the most away from the wall to the most towards it.
  std::sort(faces.begin(), faces.end());
  unsigned char best = 0;
  double largest = shapes_.fractions()(cell.leaf, cell.point);
  const auto search = [&]() {
    for (const bool any_direction : {false, true})
      for (unsigned int length = 1; length <= 2; ++length)
        for (const auto &[towards, face] : faces)
        {
          if (towards >= 0. && !any_direction)
            continue;
          double volume = 0.;
          for (const Subcell &other : chain(cell, face, length))
            volume += shapes_.fractions()(other.leaf, other.point) * other.size;
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
  // half open has a surface of (dim + 1) / 0.5. Neighbourhoods at one plane
  // wall have damping rates of at most 2.4 in 2-D and 2.6 in 3-D; the step is
  // 0.9/dim h/c at a CFL number of 0.9, and its product with the rate must stay
  // below 2, also where neighbourhoods overlap.
  const double least = 0.25, most_surface = 4. * dim, largest_rate = dim + 1.;
  const unsigned int face = best == 0 ? 0 : (best - 1) % (2 * dim);
  const Chain cells =
    best == 0 ? Chain(1, cell) : chain(cell, face, 1 + (best - 1) / (2 * dim));
  return largest < least || surface(cells, face) > most_surface * largest ||
             damping_rate(shapes_, matching_, cells, face) > largest_rate
           ? pocket
           : best;
}


template <int dim>
bool Neighborhoods<dim>::choose_in_leaf(const unsigned int leaf,
                                        Codes &codes) const
{
  codes.resize(layout().n_points, 0);
  bool has_new_pockets = false;
  for (unsigned int q = 0; q < layout().n_points; ++q)
    if (codes[q] != pocket)
    {
      const double part = shapes_.fractions()(leaf, q);
      codes[q] = part > 0. && part < 0.5 ? choose_direction({leaf, q}) : 0;
      has_new_pockets = has_new_pockets || codes[q] == pocket;
    }
  return has_new_pockets;
}


template <int dim>
void Neighborhoods<dim>::choose_directions()
{
  directions_.clear();
  shapes_.update_ghosts();
  // A closed pocket may make pockets of the cells next to it.
  const unsigned int most_rounds = 10;
  for (unsigned int round = 0; round < most_rounds; ++round)
  {
    std::map<unsigned int, Codes> pockets;
    for (unsigned int leaf = 0; leaf < shapes_.mesh().n_owned(); ++leaf)
      // Leaves without a measured shape have no small cells.
      if (shapes_.is_measured(leaf) && choose_in_leaf(leaf, directions_[leaf]))
        pockets[leaf] = directions_[leaf];
    const unsigned int n = pockets.size();
    if (dealii::Utilities::MPI::max(n, shapes_.mesh().communicator()) == 0)
      break;
    close_pockets(std::move(pockets));
  }
}


template <int dim>
void Neighborhoods<dim>::close_pockets(std::map<unsigned int, Codes> pockets)
{
  share(pockets);
  for (const auto &[leaf, codes] : pockets)
  {
    for (unsigned int q = 0; q < layout().n_points; ++q)
      if (codes[q] == pocket)
        matching_.close({leaf, q});
    shapes_.update_fractions(leaf);
  }
  matching_.match_hanging_faces();
  shapes_.update_ghosts();
}


template <int dim>
void Neighborhoods<dim>::find_neighborhoods()
{
  neighborhoods_.clear();
  memberships_.clear();
  for (const auto &[leaf, codes] : directions_)
    for (unsigned int q = 0; q < layout().n_points; ++q)
      if (codes[q] != 0 && codes[q] != pocket)
      {
        const unsigned int face = (codes[q] - 1) % (2 * dim);
        const unsigned int length = 1 + (codes[q] - 1) / (2 * dim);
        const Neighborhood neighborhood{face, chain({leaf, q}, face, length)};
        bool is_needed = false;
        for (const Subcell &cell : neighborhood.cells)
          if (cell.leaf < shapes_.mesh().n_owned())
          {
            is_needed = true;
            if (cell.size == 1. && cell.leaf == leaf && cell.point == q)
              continue;
            Codes &members = memberships_[cell.leaf];
            members.resize(layout().n_points, 0);
            ++members[cell.point];
          }
        if (is_needed)
          neighborhoods_.push_back(neighborhood);
      }
}


template <int dim>
unsigned int Neighborhoods<dim>::n_memberships(const Subcell &cell) const
{
  const auto found = memberships_.find(cell.leaf);
  return 1 + (found == memberships_.end() ? 0 : found->second[cell.point]);
}


template <int dim>
void Neighborhoods<dim>::share(std::map<unsigned int, Codes> &codes) const
{
  using Iterator = typename dealii::Triangulation<dim>::active_cell_iterator;
  if (dealii::Utilities::MPI::n_mpi_processes(shapes_.mesh().communicator()) ==
      1)
    return;
  const auto pack = [&](const Iterator &cell) -> std::optional<Codes> {
    const auto found = codes.find(shapes_.mesh().leaf_of(cell));
    if (found == codes.end())
      return {};
    return found->second;
  };
  std::map<unsigned int, Codes> received;
  const auto unpack = [&](const Iterator &cell, const Codes &values) {
    if (shapes_.mesh().leaf_of(cell) != no_leaf)
      received[shapes_.mesh().leaf_of(cell)] = values;
  };
  exchange_with_ghosts<dim, Codes>(
    shapes_.mesh().triangulation(), pack, unpack);
  codes.insert(received.begin(), received.end());
}


template class Neighborhoods<2>;
template class Neighborhoods<3>;
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/body/face_matching.h>

#include <boost/container/static_vector.hpp>

namespace contrecoup::gas
{
/**
 * Neighbourhoods of small cells, those less than half open, in which they share
 * their change: themselves and the next one or two cells along one direction,
 * the one nearest to the wall's normal that makes half a cell of volume
 * (state redistribution of Berger and Giuliani, J. Comput. Phys. 428, 109820,
 * 2021); among leaves of another size it ends with the first layer. Pockets,
 * in which none makes a quarter of a cell, or only with too large a surface,
 * are closed, as are creases, where a wall is so close to another wall or to a
 * side of the domain that waves between them forbid a CFL number of 0.9.
 * Nothing here depends on how ranks share the leaves, nor on former meshes.
 */
template <int dim>
class Neighborhoods
{
public:
  /// Cells side by side, at most 1 + 1 + 2^(dim-1).
  using Chain = boost::container::static_vector<Subcell, 6>;

  /// A small cell and the next ones beyond one of its faces, with which it
  /// shares its change.
  struct Neighborhood
  {
    unsigned int face;
    Chain cells;
  };

  /// Keeps references to the shapes, whose pockets it closes, and to what is
  /// across their faces.
  Neighborhoods(CutShapes<dim> &shapes, FaceMatching<dim> &matching)
    : shapes_(shapes)
    , matching_(matching)
  {}

  /// Finds the neighbourhoods. Call after the faces were matched. Collective.
  void reinit();

  /// Neighbourhoods of which owned leaves hold cells.
  const std::vector<Neighborhood> &all() const
  {
    return neighborhoods_;
  }
  /// Number of neighbourhoods that a cell belongs to, its own included.
  unsigned int n_memberships(const Subcell &cell) const;

  /// Whether a leaf has cells in others' neighbourhoods.
  bool has_members(const unsigned int leaf) const
  {
    return memberships_.count(leaf) > 0;
  }

private:
  /// A number for each point of a leaf; of directions: 0, pocket, or
  /// 1 + face + 2 dim (length - 1).
  using Codes = std::vector<unsigned char>;
  static constexpr unsigned char pocket = 255;

  const LeafLayout &layout() const
  {
    return shapes_.layout();
  }
  /// The cell of equal size across a face; leaf no_leaf where there is none,
  /// or where the face is closed.
  Subcell next(const Subcell &cell, const unsigned int face) const;
  /// Extends a chain beyond @p face of its last cell by the cells of a leaf
  /// of another size; returns whether there are any.
  bool cross(const unsigned int face, Chain &chain) const;
  /// The cell and the next @p length ones across a face, where leaves of
  /// another size end it; empty where there are not so many.
  Chain chain(const Subcell &cell,
              const unsigned int face,
              const unsigned int length) const;
  /// Area of what surrounds a chain across a face, walls and open faces, in
  /// parts of a face of its first cell.
  double surface(const Chain &chain, const unsigned int face) const;
  unsigned char choose_direction(const Subcell &cell) const;
  void choose_directions();
  /// For all small cells that are not yet known as pockets; returns whether
  /// there are new pockets.
  bool choose_in_leaf(const unsigned int leaf, Codes &codes) const;
  /// Closes the cells whose code is `pocket`; of ghosts as well. Collective.
  void close_pockets(std::map<unsigned int, Codes> pockets);
  void find_neighborhoods();
  /// Adds the codes of ghosts. Collective.
  void share(std::map<unsigned int, Codes> &codes) const;

  CutShapes<dim> &shapes_;
  FaceMatching<dim> &matching_;
  std::map<unsigned int, Codes> directions_; ///< per leaf with small cells
  /// Per leaf with cells in others' neighbourhoods: how many of them.
  std::map<unsigned int, Codes> memberships_;
  std::vector<Neighborhood> neighborhoods_;
};
} // namespace contrecoup::gas

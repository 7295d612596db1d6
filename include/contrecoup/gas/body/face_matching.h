// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/body/cut_shapes.h>

#include <map>
#include <utility>

namespace contrecoup::gas
{
/**
 * Neighbours across the faces of leaves at a body's surface: leaves of equal
 * size, or hanging faces. On these the fine side's openings count, closed where
 * the coarse subcell has no gas; the opening of a coarse subcell is their mean,
 * so that the surface stays closed.
 */
template <int dim>
class FaceMatching
{
public:
  /// A hanging face, and the quarter of it that a fine leaf has; no_leaf on the
  /// coarse side.
  using Side = std::pair<unsigned int, unsigned int>;

  /// Keeps a reference.
  explicit FaceMatching(CutShapes<dim> &shapes)
    : shapes_(shapes)
  {}

  /// Finds what is across faces, and matches hanging ones. Call after the
  /// shapes were measured.
  void reinit();

  /// Gives both sides of each hanging face the same openings again, after
  /// subcells were closed.
  void match_hanging_faces();

  /// Closes a subcell and its faces, on both sides within leaves of equal size.
  void close(const Subcell &cell);

  /// Whether a leaf has a place in neighbor().
  bool is_at_surface(const unsigned int leaf) const
  {
    return neighbors_.count(leaf) > 0;
  }
  /// The leaf of equal size across a face of a leaf at the surface; no_leaf
  /// where there is none or it is not known.
  unsigned int neighbor(const unsigned int leaf, const unsigned int face) const
  {
    const auto found = neighbors_.find(leaf);
    return found == neighbors_.end() ? no_leaf : found->second[face];
  }
  /// The hanging face at a face of a leaf, where leaves that meet there are cut
  /// or closed; else null.
  const Side *hanging_side(const unsigned int leaf,
                           const unsigned int face) const
  {
    const auto found = sides_.find({leaf, face});
    return found == sides_.end() ? nullptr : &found->second;
  }

  /// Whether leaves that meet there are cut or closed.
  bool is_cut_face(const unsigned int hanging_face) const
  {
    return is_cut_face_[hanging_face] != 0;
  }

  /// Open fraction of the fine subcell's face at face point @p q of the fine
  /// leaf in quarter @p part, which must be stored on this rank.
  double hanging_opening(const HangingFace<dim> &face,
                         const unsigned int part,
                         const unsigned int q) const;

  /// Coarse face point that holds the fine face point @p q of a quarter.
  unsigned int coarse_face_point(const unsigned int part,
                                 const unsigned int q) const;

private:
  void find_neighbors();
  void connect(const unsigned int leaf);
  void find_cut_faces();
  void match_coarse_side(const HangingFace<dim> &face);
  void match_fine_side(const HangingFace<dim> &face, const unsigned int part);

  CutShapes<dim> &shapes_;
  std::vector<char> is_cut_face_; ///< per hanging face
  std::map<std::pair<unsigned int, unsigned int>, Side> sides_; ///< leaf, face
  std::map<unsigned int, std::array<unsigned int, 2 * dim>> neighbors_;
};
} // namespace contrecoup::gas

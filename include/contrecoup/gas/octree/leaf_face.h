// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <deal.II/grid/tria.h>

#include <array>
#include <cstdint>
#include <utility>

namespace contrecoup::gas
{
/// Invalid leaf number.
inline constexpr unsigned int no_leaf = static_cast<unsigned int>(-1);

/**
 * Relative orientation of a leaf face and its neighbour's face. The points of
 * face f (direction d = f/2) are numbered (a, b) along the other directions in
 * increasing order, on an n^(dim-1) grid.
 */
struct FaceMatch
{
  unsigned char face = 0; ///< face number within the neighbour
  /// Bit 0: a and b are swapped (applied first), bit 1: a is reversed, bit 2:
  /// b is reversed.
  unsigned char orientation = 0;

  friend bool operator==(const FaceMatch &x, const FaceMatch &y)
  {
    return x.face == y.face && x.orientation == y.orientation;
  }
};

/// Index on the neighbour's face of face point (a, b) of this leaf, with n
/// points per direction.
inline unsigned int matched_face_point(const unsigned int orientation,
                                       unsigned int a,
                                       unsigned int b,
                                       const unsigned int n)
{
  if (orientation & 1)
    std::swap(a, b);
  if (orientation & 2)
    a = n - 1 - a;
  if (orientation & 4)
    b = n - 1 - b;
  return a + n * b;
}

/// Vertex number of a cell at corner (i, j) of one of its faces.
template <int dim>
inline unsigned int
face_corner(const unsigned int face, const unsigned int i, const unsigned int j)
{
  const unsigned int d = face / 2;
  unsigned int vertex = (face % 2) << d;
  unsigned int index = i;
  for (unsigned int t = 0; t < dim; ++t)
    if (t != d)
    {
      vertex |= index << t;
      index = j;
    }
  return vertex;
}

/// Face with one coarse leaf on one side and 2^(dim-1) fine leaves on the
/// other (2:1 balance).
template <int dim>
struct HangingFace
{
  static constexpr unsigned int n_fine = 1U << (dim - 1);

  unsigned int coarse_leaf = no_leaf;
  unsigned char coarse_face = 0;
  /// Match of the coarse face with the face of the fine leaves.
  FaceMatch match;
  /// Fine leaf of each quarter (bit 0: upper half of a, bit 1: upper half of
  /// b, in the numbering of the coarse face); no_leaf where this rank does not
  /// need it.
  std::array<unsigned int, n_fine> fine_leaf;
};

/// Leaf face without a single neighbour of equal size.
struct SpecialFace
{
  enum class Kind : unsigned char
  {
    boundary,    ///< index: boundary id
    coarse_side, ///< index: hanging face; the neighbours are finer
    fine_side,   ///< index: hanging face, part: quarter of the coarse face
  };
  Kind kind;
  unsigned char lane;
  unsigned char face;
  unsigned char part;
  unsigned int index;
};

/// Leaf of another rank that shares a face with an owned leaf.
template <int dim>
struct GhostLeaf
{
  unsigned int owner;         ///< its rank
  std::uint64_t global_index; ///< global active cell index
  unsigned char faces; ///< bit f: an owned leaf shares face f of the ghost
  typename dealii::Triangulation<dim>::cell_iterator cell;
};

/**
 * Match of two faces of cells of equal refinement level, computed from their
 * vertex indices; valid for any orientation of the coarse mesh.
 */
template <int dim>
FaceMatch
match_faces(const typename dealii::Triangulation<dim>::cell_iterator &cell,
            const unsigned int face,
            const typename dealii::Triangulation<dim>::cell_iterator &neighbor,
            const unsigned int neighbor_face);

/**
 * Area vector out of a cell [m^(dim-1)], per area of the unit square, at the
 * coordinates (@p a, @p b) from 0 to 1 of a face, in the numbering of
 * FaceMatch. Times the square's area this is exact for a rectangle of the face
 * around that place.
 */
template <int dim>
dealii::Tensor<1, dim>
outward_area(const typename dealii::Triangulation<dim>::cell_iterator &cell,
             const unsigned int face,
             const double a,
             const double b);
} // namespace contrecoup::gas

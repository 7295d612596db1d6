// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_layout.h>

#include <array>
#include <vector>

namespace contrecoup::gas
{
/// As many hanging faces that lie alike as a batch has leaves, side by side
/// in lanes.
template <int dim>
struct HangingGroup
{
  static constexpr unsigned int n_fine = HangingFace<dim>::n_fine;

  unsigned char coarse_face = 0;
  FaceMatch match;
  unsigned int n_filled = 0;
  /// Index of the face of each filled lane; others repeat the first.
  std::array<unsigned int, largest_width> face;
  /// Leaf numbers, one for each lane.
  std::array<unsigned int, largest_width> coarse_leaf;
  std::array<std::array<unsigned int, largest_width>, n_fine> fine_leaf;
  /// Positions in the state array, one for each lane.
  std::array<unsigned int, largest_width> coarse_offset;
  std::array<std::array<unsigned int, largest_width>, n_fine> fine_offset;
  /// See relative_inner_radius(); one for each lane.
  std::array<double, largest_width> inner_radius;
  bool is_radial = false; ///< whether any of these is finite
};

/// Inner radius of a face's coarse leaf in units of its radial edge, where the
/// face runs along the radius of an axisymmetric mesh; infinite elsewhere, and
/// for ghosts: only the owner of the coarse leaf takes what it weights.
template <int dim>
double relative_inner_radius(const LeafMesh<dim> &mesh,
                             const HangingFace<dim> &face);

/// Radius in the middle of a fine subcell's face, in parts of that of the
/// coarse one.
/// @param inner relative_inner_radius()
/// @param n subcells of a leaf along the radius
/// @param index which of them the coarse one is
/// @param distance from its middle to the fine one's in its edge lengths
template <typename Number>
inline Number relative_radius(const Number &inner,
                              const unsigned int n,
                              const unsigned int index,
                              const double distance)
{
  return Number(distance) / (inner * double(n) + (index + 0.5)) + 1.;
}

/// Sorts the hanging faces of @p mesh into groups. A fine leaf that this
/// rank does not need is stood in for by another one of the same face.
template <int dim>
std::vector<HangingGroup<dim>> group_hanging_faces(const LeafMesh<dim> &mesh,
                                                   const LeafLayout &layout);
} // namespace contrecoup::gas

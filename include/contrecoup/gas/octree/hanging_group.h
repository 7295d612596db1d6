// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_layout.h>

#include <array>
#include <vector>

namespace contrecoup::gas
{
/// Batch of hanging faces with equal face numbers and orientation, one hanging
/// face per lane.
template <int dim>
struct HangingGroup
{
  static constexpr unsigned int n_fine = HangingFace<dim>::n_fine;

  unsigned char coarse_face = 0;
  FaceMatch match;
  unsigned int n_filled = 0;
  /// Index of the hanging face, per lane; unfilled lanes repeat the first.
  std::array<unsigned int, max_batch_width> face;
  /// Leaf numbers, per lane.
  std::array<unsigned int, max_batch_width> coarse_leaf;
  std::array<std::array<unsigned int, max_batch_width>, n_fine> fine_leaf;
  /// Offsets in the state array, per lane; see LeafLayout::offset().
  std::array<unsigned int, max_batch_width> coarse_offset;
  std::array<std::array<unsigned int, max_batch_width>, n_fine> fine_offset;
  /// See relative_inner_radius(); per lane.
  std::array<double, max_batch_width> inner_radius;
  bool is_radial = false;             ///< whether any inner_radius is finite
  unsigned int first_batch = no_leaf; ///< lowest of the owned leaves' batches
};

/// Inner radius of the coarse leaf divided by its radial edge length, where
/// the face is parallel to the radius of an axisymmetric mesh; infinite
/// elsewhere and for ghosts, because only the owner of the coarse leaf uses
/// the weighted fluxes.
template <int dim>
double relative_inner_radius(const LeafMesh<dim> &mesh,
                             const HangingFace<dim> &face);

/// Ratio of the radius at the centre of a fine subcell's face to that of the
/// coarse subcell's face.
/// @param inner relative_inner_radius()
/// @param n subcells of a leaf along the radius
/// @param index index of the coarse subcell along the radius
/// @param distance from the centre of the coarse subcell to that of the fine
/// one, in edge lengths of the coarse subcell
template <typename Number>
inline Number relative_radius(const Number &inner,
                              const unsigned int n,
                              const unsigned int index,
                              const double distance)
{
  return Number(distance) / (inner * double(n) + (index + 0.5)) + 1.;
}

/// Sorts the hanging faces of @p mesh into groups, in increasing order of
/// HangingGroup::first_batch. Where this rank does not need a fine leaf,
/// another fine leaf of the same face takes its lane.
template <int dim>
std::vector<HangingGroup<dim>> group_hanging_faces(const LeafMesh<dim> &mesh,
                                                   const LeafLayout &layout);
} // namespace contrecoup::gas

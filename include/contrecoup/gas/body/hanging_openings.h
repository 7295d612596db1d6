// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/body/cut_leaves.h>
#include <contrecoup/gas/octree/hanging_group.h>

#include <deal.II/base/aligned_vector.h>

#include <array>

namespace contrecoup::gas
{
/// Parts outside a rigid body of the subcells that the flux through a group of
/// hanging faces depends on, leaves side by side in lanes. Arrays are indexed
/// by face point of the coarse or fine leaves, in the coarse numbering.
template <int dim, typename Real>
struct HangingOpenings
{
  using Number = Lanes<Real>;
  using Values = dealii::AlignedVector<Number>;
  static constexpr unsigned int n_fine = HangingFace<dim>::n_fine;

  /// Takes over the shapes of the leaves of @p group.
  void reinit(const HangingGroup<dim> &group,
              const LeafMesh<dim> &mesh,
              const LeafLayout &layout,
              const CutLeaves<dim> &cut_leaves);

  /// One in lanes of faces next to a cut leaf, else zero. In other lanes the
  /// means over fine subcells are computed as in groups without openings, since
  /// which faces share a group depends on the ranks.
  Number is_cut;
  /// One or zero: whether gas of a coarse subcell touches that of the next one
  /// along each face coordinate, and of the one below.
  std::array<Values, dim == 1 ? 1 : dim - 1> along;
  Values below;
  /// Per quarter of the face: its open fraction.
  std::array<Values, n_fine> opening;
  /// Per quarter: one or zero, whether gas of a fine subcell touches that of
  /// the one below.
  std::array<Values, n_fine> fine_below;
  /// Per quarter and layer: open fraction of the volume of subcells that are
  /// reached through the face, else zero.
  std::array<std::array<Values, 2>, n_fine> fraction;
};
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/adaptation_parameters.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/octree/leaf_mesh.h>

namespace contrecoup::gas
{
/// Refinement levels allowed for owned leaves: general bounds of the
/// parameters, the fine box, size limits, and the level that a rigid body
/// requires at its surface.
template <int dim>
class LeafLevels
{
public:
  /// Keeps references to its arguments.
  LeafLevels(const AdaptationParameters &parameters, const LeafMesh<dim> &mesh)
    : parameters_(parameters)
    , mesh_(mesh)
  {}

  /// Sets a rigid body, which must outlive this object: leaves that its surface
  /// intersects, and their neighbours, have exactly the level that the body
  /// prescribes, counted from @p initial_level.
  void set_body(const RigidBody &body, const unsigned int initial_level)
  {
    body_ = &body;
    initial_level_ = initial_level;
  }

  /// Levels allowed for a leaf at @p time [s].
  SizeLimits::Levels levels(const unsigned int leaf, const double time) const;

  /// Whether a leaf at the body is below its prescribed level.
  bool is_too_coarse_at_body(const unsigned int leaf) const;

  /// Largest level that fine box and size limits allow for a leaf at @p time
  /// [s].
  unsigned int max_level(const unsigned int leaf, const double time) const;

  /// Smallest level of a leaf that 2:1 balance with the leaves at the body
  /// allows.
  unsigned int min_level_near_body(const unsigned int leaf) const;

  /// Per leaf at @p time [s]: ratio of the leaf's size to the smallest size
  /// that adaptation allows for fronts there, at most 1 [-]. Leaves at a body
  /// may be smaller; the AMR buffer shrinks by this factor there.
  std::vector<double> size_ratios(const double time) const;

private:
  /// The levels @p general, restricted by fine box and size limits.
  SizeLimits::Levels narrowed(const unsigned int leaf,
                              SizeLimits::Levels general,
                              const double time) const;
  /// See RigidBody::leaf_diagonals_to().
  double leaf_diagonals_from_body(const unsigned int leaf) const;
  /// Prescribed level of the leaf if it is at the body.
  unsigned int body_level(const unsigned int leaf) const;
  bool is_in_fine_box(const dealii::Point<dim> &place) const;

  const AdaptationParameters &parameters_;
  const LeafMesh<dim> &mesh_;
  const RigidBody *body_ = nullptr;
  unsigned int initial_level_ = 0;
};
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/adaptation_parameters.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/octree/leaf_mesh.h>

namespace contrecoup::gas
{
/// The refinement levels that owned leaves may have: as the parameters bound
/// them in general, in the fine box and by limits of size, and as a rigid body
/// demands at its surface.
template <int dim>
class LeafLevels
{
public:
  /// Keeps references.
  LeafLevels(const AdaptationParameters &parameters, const LeafMesh<dim> &mesh)
    : parameters_(parameters)
    , mesh_(mesh)
  {}

  /// Leaves that meet the surface of @p body, and those within one such leaf
  /// of it, shall be halved as often as the body says beyond @p initial_level,
  /// neither more nor less; the body must outlive this object.
  void set_body(const RigidBody &body, const unsigned int initial_level)
  {
    body_ = &body;
    initial_level_ = initial_level;
  }

  /// Levels that a leaf may have at time @p time [s].
  SizeLimits::Levels levels(const unsigned int leaf, const double time) const;

  /// Whether a leaf at the body is coarser than it shall be.
  bool is_too_coarse_at_body(const unsigned int leaf) const;

  /// The finest level that fine box and limits of size let a leaf have at time
  /// @p time [s].
  unsigned int max_level(const unsigned int leaf, const double time) const;

  /// The coarsest level that a leaf can have beside the leaves at the body.
  unsigned int min_level_near_body(const unsigned int leaf) const;

  /// For each leaf at time @p time [s], the ratio of its edge length to that of
  /// the smallest leaf that fronts may have there, at most 1: a front in a
  /// smaller leaf, beside a body, has a buffer that is thinner by it [-].
  std::vector<double> size_ratios(const double time) const;

private:
  /// What fine box and limits leave of the levels @p general.
  SizeLimits::Levels narrowed(const unsigned int leaf,
                              SizeLimits::Levels general,
                              const double time) const;
  /// See RigidBody::leaf_diagonals_to().
  double leaf_diagonals_from_body(const unsigned int leaf) const;
  /// Level that the leaf shall have if it is at the body.
  unsigned int body_level(const unsigned int leaf) const;
  bool is_in_fine_box(const dealii::Point<dim> &place) const;

  const AdaptationParameters &parameters_;
  const LeafMesh<dim> &mesh_;
  const RigidBody *body_ = nullptr;
  unsigned int initial_level_ = 0;
};
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/octree/leaf_layout.h>

#include <array>
#include <vector>

namespace contrecoup::gas
{
/// Open fractions, outside a rigid body, of the subcells of a leaf and of their
/// faces, from 0 to 1 [-].
template <int dim>
struct LeafShape
{
  /// Whether all of it is open.
  bool is_open() const;

  std::vector<double> fraction; ///< of each point's volume
  /// Fraction of the subcell faces across each direction, [layer][line]; lines
  /// are numbered as in LeafKernel.
  std::array<std::vector<double>, dim> opening;
};


/**
 * Subcells and faces cut by the surface, from the signed distance at the
 * subcells' corners; see positive_fraction().
 *
 * @param is_axisymmetric whether the leaf is turned about x = 0: faces across
 * that axis are then open by the fraction of their ring. All else is as in the
 * plane; with the radius in a cell's middle its volume and the wall in it
 * differ from the exact ones by less than the cell's edge over the radius.
 */
template <int dim>
LeafShape<dim> cut_shape(const LeafBox<dim> &box,
                         const LeafLayout &layout,
                         const RigidBody &body,
                         const bool is_axisymmetric);

/// Subcells that are gas or body by their centre, and faces that are open
/// between two of gas.
template <int dim>
LeafShape<dim> staircase_shape(const LeafBox<dim> &box,
                               const LeafLayout &layout,
                               const RigidBody &body);
} // namespace contrecoup::gas

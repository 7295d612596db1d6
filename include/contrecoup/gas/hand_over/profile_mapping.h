// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/profile_field.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/materials/gas_material.h>

#include <string>

namespace contrecoup::gas
{
/// Result of map_profile().
struct ProfileMapping
{
  /// Whether the domain contains the whole profile, or a part between planes
  /// through its centre, so that the totals are known.
  bool is_complete = false;
  /// Mass of air [kg], mass of products [kg] and energy [J] of the disturbed
  /// gas: exact, and as integrated from the mapped means.
  std::array<double, 3> wanted{}, found{};
  /// Correction factors of air, products and internal energy [-].
  std::array<double, 3> factors{{1., 1., 1.}};
};

/**
 * Maps a profile onto a field. Each point of a leaf gets the mean of the
 * profile over its subcell (Galerkin nodes: over the part of the leaf that
 * belongs to the node), integrated over parts that are bisected where the
 * profile varies. Total energy is averaged too, so that kinetic energy lost in
 * the means of momentum becomes internal energy. Then mass of air, mass of
 * products and internal energy are each multiplied by one factor at constant
 * velocity, so that the totals of the disturbed gas equal those of the profile
 * to round-off; no correction is made if the domain cuts the profile other
 * than by planes through its centre. Collective.
 *
 * @param rough true: for choosing a mesh; no bisection and no correction
 * @throws NumericsError when a state would become unphysical
 */
template <int dim>
ProfileMapping map_profile(const ProfileField<dim> &profile,
                           const LeafMesh<dim> &mesh,
                           const LeafPoints<dim> &points,
                           const GasMaterial &material,
                           GasField &field,
                           const bool rough = false);

/**
 * Whether the profile varies by more than 5 % across a subcell of the leaf, so
 * that the leaf must be refined.
 */
template <int dim>
bool is_steep_in(const ProfileField<dim> &profile,
                 const LeafBox<dim> &leaf,
                 const unsigned int n_points);

/// Totals and factors of a mapping as lines for the log.
std::string to_text(const ProfileMapping &mapping, const bool has_products);
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/profile_field.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/leaf_sampling.h>

#include <string>

namespace contrecoup::gas
{
/// What map_profile() did.
struct ProfileMapping
{
  /// Whether the profile's body, or parts of it between planes through its
  /// centre, is in the domain, so that its totals are known.
  bool is_complete = false;
  /// Mass of air, mass of products [kg] and energy [J] of the gas that the
  /// profile disturbs: as they must be, and as cell means found them.
  std::array<double, 3> wanted{}, found{};
  /// What air, products and internal energy were multiplied with.
  std::array<double, 3> factors{{1., 1., 1.}};
};

/**
 * Fills a field with a profile. Each point of a leaf gets the mean of the
 * profile over its subcell (Galerkin nodes: over the part of the leaf that
 * they stand for), taken from parts of it that are halved where the profile
 * varies; total energy is a mean as well, so that kinetic energy that means
 * of momentum lose becomes heat. Then mass of air, mass of products and
 * internal energy are multiplied with one factor each, at constant velocity,
 * so that the totals of the disturbed gas are those of the profile to
 * round-off; if the domain cuts the profile other than by planes through its
 * centre, nothing is. Collective.
 * @param rough for choosing a mesh: no part is halved and nothing multiplied
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
 * Whether the profile varies by more than 5 % across a subcell of the leaf,
 * which then is too coarse for it.
 */
template <int dim>
bool is_steep_in(const ProfileField<dim> &profile,
                 const LeafBox<dim> &leaf,
                 const unsigned int n_points);

/// Lines that say what was mapped, for the log.
std::string to_text(const ProfileMapping &mapping, const bool has_products);
} // namespace contrecoup::gas

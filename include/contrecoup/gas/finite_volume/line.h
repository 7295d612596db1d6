// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/scheme.h>
#include <contrecoup/gas/state/burn.h>
#include <contrecoup/gas/state/primitive.h>

#include <array>

namespace contrecoup::gas
{
/**
 * A row of subcells along one direction of the leaves of a batch, one leaf per
 * lane, with all that the fluxes between these subcells depend on. Velocities
 * are in the frame of the line: the component along it comes first.
 */
template <typename Number, unsigned int n_components>
struct Line
{
  using Values = std::array<Number, n_components>;

  const Scheme *scheme = nullptr;
  unsigned int n = 1; ///< subcells of the leaf
  /// Primitive values of the first subcell. Two subcells before it and two
  /// behind the last one have values too.
  const Values *subcells = nullptr;
  /// Work space for subcells -1 to n: the difference of the primitive values
  /// from the centre to the high face, and the mass fraction of products at the
  /// low and the high face.
  Values *half_slopes = nullptr;
  std::array<Number, 2> *end_products = nullptr;
  /// Whether velocity slopes are bounded; see Stage::bound_velocity_slopes.
  bool bounds_velocity = false;

  /// Where explosive is still to burn: Burn::progress() of subcells -1 to n.
  const Burn *burn = nullptr;
  const Number *progress = nullptr;

  /// Where the flux may need a shear factor: the most negative velocity
  /// difference across the line at subcells -1 to n [m/s]; else null.
  const Number *compression = nullptr;
  /// Positive in lanes with a shock next to the first face, the inner faces
  /// and the last face.
  std::array<Number, 3> shock;

  /// One in lanes of leaves with a shock at an open boundary along the line;
  /// null: none.
  const Number *leaving = nullptr;

  /// At the first and last face: fluxes of hanging faces in the lanes that
  /// have one; null: no lane has.
  std::array<const Values *, 2> hanging_flux = {{nullptr, nullptr}};
  std::array<const Number *, 2> has_hanging = {{nullptr, nullptr}};
};
} // namespace contrecoup::gas

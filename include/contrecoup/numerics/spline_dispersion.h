// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/**
 * Plane waves in the material point method on a grid of cardinal B-splines,
 * with particles so dense that their sums are integrals, and short steps. With
 * the phase q of a wave from one node to the next, the mass and stiffness of
 * the splines have the symbols
 *
 *   M = sum_j B_{2p+1}(j) cos(j q),   K = -sum_j B''_{2p+1}(j) cos(j q)
 *
 * of the centred spline of degree 2 p + 1. Particles that get increments of
 * velocities from nodes with lumped masses (FLIP, USF or MUSL) feel
 * w^2 = (c / h)^2 K M; with k terms of the series that inverts the mass, on
 * velocities as on forces, w^2 = (c / h)^2 K M S^2 with S = sum_{i < k}
 * (1 - M)^i; the consistent mass has K / M.
 */
class SplineDispersion
{
public:
  /// @param degree p of the splines: 1, 2 or 3
  explicit SplineDispersion(const unsigned int degree);

  /// M.
  double mass(const double phase) const;

  /// K, of h u'' = -K / h u.
  double stiffness(const double phase) const;

  /**
   * Speed of waves over that of sound.
   * @param cells in a wave's length, above 2
   * @param terms of the series; 1: lumped
   */
  double speed(const double cells, const unsigned int terms = 1) const;

  /// The same with the consistent mass.
  double consistent_speed(const double cells) const;

private:
  unsigned int degree_;
};
} // namespace contrecoup

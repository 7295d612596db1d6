// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/**
 * Dispersion of plane waves in the material point method on cardinal
 * B-splines, for dense particles (exact integrals) and small steps. With the
 * phase q of a wave between adjacent nodes, the mass and stiffness matrices
 * have the symbols
 *
 *   M = sum_j B_{2p+1}(j) cos(j q),   K = -sum_j B''_{2p+1}(j) cos(j q)
 *
 * of the centred spline of degree 2 p + 1. If particles get velocity
 * increments from nodes with lumped masses (FLIP, USF or MUSL), w^2 = (c /
 * h)^2 K M. With k terms of the series for the inverse mass, applied to
 * velocities and forces, w^2 = (c / h)^2 K M S^2 with S = sum_{i < k} (1 -
 * M)^i. The consistent mass gives K / M.
 */
class SplineDispersion
{
public:
  /// @param degree p of the splines: 1, 2 or 3
  explicit SplineDispersion(const unsigned int degree);

  /// Symbol M.
  double mass(const double phase) const;

  /// Symbol K, h u'' = -K / h u.
  double stiffness(const double phase) const;

  /**
   * Numerical wave speed over the exact one.
   * @param cells per wave length, above 2
   * @param terms of the series; 1: lumped mass
   */
  double speed(const double cells, const unsigned int terms = 1) const;

  /// The same with consistent mass.
  double consistent_speed(const double cells) const;

private:
  unsigned int degree_;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>

/**
 * @file
 * Nodal average of pressures that alternate from element to element. Elements
 * with one dilatation leave hourglass modes whose dilatation D alternates
 * between neighbours, nearly without force and with long periods, so that
 * viscosity hardly damps them. A part beta of the pressure -K D is replaced by
 * its average over the corners of the element, where each corner holds the
 * average of its elements (after Bonet and Burton, Commun. Numer. Meth. Engng.
 * 14 (1998) 437, and, for the part that is left to each element, Puso and
 * Solberg, Int. J. Numer. Meth. Engng. 67 (2006) 841):
 *   p = -K D + q,  q = beta (K S - A K S).
 * With weights volume over K, A is symmetric with eigenvalues from 0 to 1, so
 * that, at rest, p derives from an energy. On cubes a wave of n elements has
 * q = beta sin^2(pi / n) K S. S is the dilatation of the steps before,
 *   S <- lambda S + (1 - lambda) D,
 * so that one pass over the elements is enough. It lags behind D, hence q
 * takes energy at every frequency that time steps resolve. With lambda = 0 the
 * stable step would be that of (1 + beta) K, with lambda it is that of
 * (1 + beta (1 - lambda) / (1 + lambda)) K. All this is for pressures in
 * proportion to the dilatation.
 */

namespace contrecoup
{
/// Constants of the elements of one tissue.
template <typename Number>
struct PressureSmoothing
{
  /// lambda: S follows D within four steps.
  static constexpr double memory = 0.75;

  /// Factor on K for the stable step. @param part beta
  static double stiffening(const double part)
  {
    return 1. + part * (1. - memory) / (1. + memory);
  }

  bool active = false;
  Number bulk{};      ///< beta K [Pa]
  Number reference{}; ///< beta times the largest K of the smoothed tissues [Pa]
  /// q [Pa] from S, and from the mean over the corners of K S over the largest
  /// K.
  DEAL_II_ALWAYS_INLINE Number pressure(const Number &smooth,
                                        const Number &nodal_average) const
  {
    return bulk * smooth - reference * nodal_average;
  }

  /// Advances S by one step.
  static DEAL_II_ALWAYS_INLINE Number advance(const Number &smooth,
                                              const Number &dilatation)
  {
    return dilatation + Number(memory) * (smooth - dilatation);
  }
};
} // namespace contrecoup

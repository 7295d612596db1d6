// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/explosives.h>
#include <contrecoup/numerics/exact/radial_state.h>

#include <vector>

namespace contrecoup
{
/**
 * Taylor wave behind a Chapman-Jouguet detonation that runs from a plane, axis
 * or centre at constant speed D (G. I. Taylor, Proc. R. Soc. A 200 (1950)
 * 235-247). The flow depends on xi = r / t only and is isentropic:
 *
 *   d xi / d u = ((xi - u)^2 / c^2 - 1) xi / (m u),
 *   d ln rho / d u = (xi - u) / c^2,
 *
 * m = 1 for an axis and 2 for a centre; for a plane xi = u + c. The wave ends
 * at a core at rest, whose edge moves at the sound speed of the core.
 */
class DetonationSolution
{
public:
  /**
   * @param dimension 1 plane, 2 cylindrical, 3 spherical
   * @throws InputError for another dimension and for constants without a
   * Chapman-Jouguet state.
   */
  DetonationSolution(const unsigned int dimension, const JwlParameters &jwl);

  /// State just behind the front.
  const ChapmanJouguetState &front() const
  {
    return front_;
  }

  /// Speed of the core's edge [m/s].
  double core_speed() const
  {
    return points_.front().speed;
  }

  /// State at @p speed = r / t [m/s], at most D.
  RadialState value(const double speed) const;

private:
  struct Point
  {
    double speed; ///< xi [m/s]
    RadialState state;
  };

  ChapmanJouguetState front_;
  std::vector<Point> points_; ///< from the core to the front
};
} // namespace contrecoup

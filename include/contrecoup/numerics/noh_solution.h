// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/radial_state.h>

namespace contrecoup
{
/**
 * The implosion of W. F. Noh (J. Comput. Phys. 72 (1987) 78-120, section
 * 4): cold ideal gas of uniform density runs with uniform speed onto a
 * wall, axis or centre, and a shock of infinite strength stands between it
 * and gas at rest.
 */
class NohSolution
{
public:
  /**
   * @param dimension 1 plane, 2 cylindrical, 3 spherical
   * @param gamma ratio of specific heats [-], above 1
   * @param density initial density [kg/m^3], above 0
   * @param speed initial speed towards the centre [m/s], above 0
   * @throws InputError for numbers outside these ranges.
   */
  NohSolution(unsigned int dimension,
              double gamma,
              double density,
              double speed);

  /// Speed of the shock away from the centre [m/s].
  double shock_speed() const;

  /// The state at @p radius [m] and @p time [s], both not negative. Ahead of
  /// the shock the pressure is zero.
  RadialState value(double radius, double time) const;

private:
  unsigned int dimension_;
  double gamma_;
  double density_;
  double speed_;
};
} // namespace contrecoup

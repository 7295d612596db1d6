// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/exact/radial_state.h>

namespace contrecoup
{
/**
 * Noh's implosion (W. F. Noh, J. Comput. Phys. 72 (1987) 78-120, section 4):
 * cold ideal gas of uniform density moves with uniform speed towards a wall,
 * axis or centre, where a shock of infinite strength brings it to rest.
 */
class NohSolution
{
public:
  /**
   * @param dimension 1 plane, 2 cylindrical, 3 spherical
   * @param gamma ratio of specific heats [-], above 1
   * @param density initial density [kg/m^3], positive
   * @param speed initial speed towards the centre [m/s], positive
   * @throws InputError for values outside these ranges
   */
  NohSolution(unsigned int dimension,
              double gamma,
              double density,
              double speed);

  /// Speed of the shock away from the centre [m/s].
  double shock_speed() const;

  /// State at @p radius [m] and @p time [s], neither negative. Pressure is
  /// zero ahead of the shock.
  RadialState value(double radius, double time) const;

private:
  unsigned int dimension_;
  double gamma_;
  double density_;
  double speed_;
};
} // namespace contrecoup

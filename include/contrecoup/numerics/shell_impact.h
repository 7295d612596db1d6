// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/numbers.h>

#include <cmath>

namespace contrecoup
{
/**
 * A thin elastic sphere that is full of liquid runs onto a rigid wall, in the
 * closed form of P. G. Young (2003): its whole mass on the spring that a
 * shallow shell is under a load at a point (E. Reissner, 1946). It is in
 * contact for half a period, and its liquid has the pressure of a slow
 * deceleration.
 */
struct ShellImpact
{
  double mass = 0.;      ///< of shell and liquid [kg]
  double radius = 0.;    ///< of the middle of the shell [m]
  double thickness = 0.; ///< [m]
  double young_modulus = 0.;
  double poisson_ratio = 0.;
  double speed = 0.; ///< along the normal of the wall [m/s]

  /// 4 E h^2 / (R sqrt(3 (1 - nu^2))) [N/m].
  double stiffness() const
  {
    return 4. * young_modulus * thickness * thickness /
           (radius * std::sqrt(3. * (1. - poisson_ratio * poisson_ratio)));
  }

  /// [s]
  double contact_time() const
  {
    return dealii::numbers::PI * std::sqrt(mass / stiffness());
  }

  /// [N]
  double peak_force() const
  {
    return speed * std::sqrt(stiffness() * mass);
  }

  /// Of a liquid of this density at the wall, and with the other sign at the
  /// far end, when the deceleration is largest [Pa].
  double peak_pressure(const double density, const double liquid_radius) const
  {
    return density * peak_force() / mass * liquid_radius;
  }
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/numbers.h>

#include <cmath>

namespace contrecoup
{
/**
 * Impact of a thin elastic sphere filled with liquid on a rigid wall, in the
 * closed form of P. G. Young (2003): the total mass on a spring with the
 * stiffness of a shallow shell under a point load (E. Reissner, 1946). Contact
 * lasts for half a period; the liquid's pressure is that of a slow
 * deceleration.
 */
struct ShellImpact
{
  double mass = 0.;      ///< of shell and liquid [kg]
  double radius = 0.;    ///< of the shell's middle surface [m]
  double thickness = 0.; ///< [m]
  double young_modulus = 0.;
  double poisson_ratio = 0.;
  double speed = 0.; ///< normal to the wall [m/s]

  /// Spring stiffness 4 E h^2 / (R sqrt(3 (1 - nu^2))) [N/m].
  double stiffness() const
  {
    return 4. * young_modulus * thickness * thickness /
           (radius * std::sqrt(3. * (1. - poisson_ratio * poisson_ratio)));
  }

  /// Duration of contact [s].
  double contact_time() const
  {
    return dealii::numbers::PI * std::sqrt(mass / stiffness());
  }

  /// Largest contact force [N].
  double peak_force() const
  {
    return speed * std::sqrt(stiffness() * mass);
  }

  /// Peak pressure at the wall in a liquid of this density [Pa]; with opposite
  /// sign at the far end.
  double peak_pressure(const double density, const double liquid_radius) const
  {
    return density * peak_force() / mass * liquid_radius;
  }
};
} // namespace contrecoup

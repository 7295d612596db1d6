// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/numbers.h>

#include <cmath>

namespace contrecoup
{
/**
 * Longitudinal vibration of a thin elastic bar, fixed at x = 0 and free at x =
 * L, with the initial velocity v_0 sin(k x), k = (n - 1/2) pi / L:
 *
 *   v = v_0 sin(k x) cos(w t),   w = k sqrt(E / rho).
 */
struct VibratingBar
{
  double length = 25.;         ///< L [m]
  double young_modulus = 100.; ///< E; of a bar that may not get thicker, that
                               ///< of the constrained bar [Pa]
  double density = 1.;         ///< rho [kg/m^3]
  double speed = 0.1;          ///< v_0 [m/s]
  unsigned int mode = 1;       ///< n

  double wave_number() const
  {
    return (mode - 0.5) * dealii::numbers::PI / length;
  }

  /// w [1/s]
  double frequency() const
  {
    return wave_number() * std::sqrt(young_modulus / density);
  }

  /// Period [s].
  double period() const
  {
    return 2. * dealii::numbers::PI / frequency();
  }

  /// v [m/s].
  double velocity(const double x, const double time) const
  {
    return speed * std::sin(wave_number() * x) * std::cos(frequency() * time);
  }

  /// Displacement [m].
  double displacement(const double x, const double time) const
  {
    return speed / frequency() * std::sin(wave_number() * x) *
           std::sin(frequency() * time);
  }

  /// Velocity of the centre of mass [m/s].
  double mean_velocity(const double time) const
  {
    return speed * std::cos(frequency() * time) / (wave_number() * length);
  }

  /// Total energy per cross-section [J/m^2].
  double energy() const
  {
    return 0.25 * density * speed * speed * length;
  }
};
} // namespace contrecoup

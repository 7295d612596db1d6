// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>

namespace contrecoup
{
/**
 * Air that carries a mass fraction of products too small to act on it: what
 * MieGrueneisen::jwl_in_air() is where the gas is dilute, see
 * MieGrueneisen::is_air(). An ideal gas without divisions by mixed
 * coefficients. Arguments are as in IdealGas.
 */
class TracedAir
{
public:
  static constexpr bool has_products = true;

  /// @param omega gamma - 1 [-]
  explicit TracedAir(const double omega)
    : omega_(omega)
    , inverse_omega_(1. / omega)
  {}

  /// Internal energy per volume rho e [J/m^3].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number
  internal_energy_density(const Number & /*density*/,
                          const Number &pressure,
                          const Number & /*products*/) const
  {
    return Number(inverse_omega_) * pressure;
  }

  /// Lower bound of the admissible rho e [J/m^3]: zero.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number
  least_energy_density(const Number & /*density*/,
                       const Number & /*products*/) const
  {
    return Number(0.);
  }

  /// rho e [J/m^3] and square of the sound speed [m^2/s^2] from density and
  /// pressure.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE void
  energy_and_sound_speed(const Number &density,
                         const Number &pressure,
                         const Number &products,
                         Number &internal_energy_density,
                         Number &sound_speed_squared) const
  {
    internal_energy_density =
      this->internal_energy_density(density, pressure, products);
    // With one more than omega in the precision of the lanes, as mixtures.
    sound_speed_squared =
      (Number(omega_) + 1.) * pressure * (Number(1.) / density);
  }

private:
  double omega_;
  double inverse_omega_;
};
} // namespace contrecoup

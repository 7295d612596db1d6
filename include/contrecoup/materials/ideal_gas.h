// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>

namespace contrecoup
{
/**
 * Calorically perfect gas, p = (gamma - 1) rho e and T = p / (rho R).
 *
 * All functions work on double, float and lanes. Arguments are density
 * [kg/m^3], internal energy density rho e [J/m^3], pressure [Pa] and the mass
 * fraction of explosive products [-], which this gas ignores. States with rho
 * > 0 and rho e > 0 are admissible; non-positive density gives infinities, but
 * no floating point trap.
 */
class IdealGas
{
public:
  static constexpr bool has_products = false;

  /// @param gamma ratio of specific heats [-], above 1
  /// @param gas_constant R [J/(kg K)]; the default is dry air
  explicit IdealGas(const double gamma = 1.4,
                    const double gas_constant = 287.05287)
    : gamma_(gamma)
    , gas_constant_(gas_constant)
    , inverse_gamma_minus_one_(1. / (gamma - 1.))
  {}

  /// Ratio of specific heats [-].
  double gamma() const
  {
    return gamma_;
  }

  /// Pressure [Pa].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number pressure(const Number & /*density*/,
                                        const Number &internal_energy_density,
                                        const Number & /*products*/) const
  {
    return internal_energy_density * (gamma_ - 1.);
  }

  /// Internal energy density rho e [J/m^3].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number
  internal_energy_density(const Number & /*density*/,
                          const Number &pressure,
                          const Number & /*products*/) const
  {
    return pressure * inverse_gamma_minus_one_;
  }

  /// Squared sound speed [m^2/s^2].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number
  sound_speed_squared(const Number &density,
                      const Number &pressure,
                      const Number & /*products*/) const
  {
    return pressure * gamma_ * (Number(1.) / density);
  }

  /// Lower bound of the admissible rho e [J/m^3]: zero.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number
  least_energy_density(const Number & /*density*/,
                       const Number & /*products*/) const
  {
    return Number(0.);
  }

  /// Temperature [K].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number temperature(const Number &density,
                                           const Number &pressure,
                                           const Number & /*products*/) const
  {
    return pressure / (density * gas_constant_);
  }

  /// Pressure [Pa] and squared sound speed from density and rho e.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE void
  pressure_and_sound_speed(const Number &density,
                           const Number &internal_energy_density,
                           const Number &products,
                           Number &pressure,
                           Number &sound_speed_squared) const
  {
    pressure = this->pressure(density, internal_energy_density, products);
    sound_speed_squared =
      this->sound_speed_squared(density, pressure, products);
  }

  /// rho e [J/m^3] and squared sound speed from density and pressure.
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
    sound_speed_squared =
      this->sound_speed_squared(density, pressure, products);
  }

private:
  double gamma_;
  double gas_constant_;
  double inverse_gamma_minus_one_;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/exponential.h>
#include <contrecoup/base/lanes/logarithm.h>

#include <limits>

namespace contrecoup
{
/**
 * Tait liquid; its pressure depends on density only:
 *
 *   p = B ((rho / rho_0)^n - 1),   B = K_0 / n,
 *
 * so that K_0 is the bulk modulus at zero pressure. Below the density at which
 * p falls to the least pressure p_c the liquid cavitates, and p stays at p_c.
 * The stored energy is the integral of p / rho^2 in both ranges, so that it is
 * recoverable; internal energy beyond it is heat and does not affect the
 * pressure. Cole (1948), Underwater Explosions, gives n = 7.15 for water.
 *
 * Arguments are as in IdealGas; internal energy and products are ignored.
 */
class Tait
{
public:
  static constexpr bool has_products = false;

  /// @param density rho_0 [kg/m^3]
  /// @param bulk_modulus K_0 [Pa]
  /// @param exponent n [-], above 1
  /// @param least_pressure p_c [Pa], at most 0; minus infinity: the liquid
  /// sustains any tension
  /// @throws InputError for unphysical constants
  Tait(double density,
       double bulk_modulus,
       double exponent = 7.15,
       double least_pressure = -std::numeric_limits<double>::infinity());

  double density() const
  {
    return density_;
  }

  /// Density at which cavitation begins [kg/m^3]; 0: no cavitation.
  double cavitation_density() const
  {
    return cavitation_density_;
  }

  /// Pressure [Pa].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number pressure(const Number &density,
                                        const Number & /*energy*/,
                                        const Number & /*products*/) const
  {
    const Number liquid = (power(density) - Number(1.)) * factor_;
    return select_less(
      density, Number(cavitation_density_), Number(least_pressure_), liquid);
  }

  /// Pressure [Pa] and squared sound speed [m^2/s^2]; in a cavitating liquid,
  /// the sound speed of the remaining liquid.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE void
  pressure_and_sound_speed(const Number &density,
                           const Number & /*energy*/,
                           const Number & /*products*/,
                           Number &pressure,
                           Number &sound_speed_squared) const
  {
    const Number floor(cavitation_density_);
    const Number liquid_density = std::max(density, floor);
    const Number ratio = power(liquid_density);
    pressure = select_less(
      density, floor, Number(least_pressure_), (ratio - Number(1.)) * factor_);
    sound_speed_squared = ratio * (factor_ * exponent_) / liquid_density;
  }

  /// Specific energy stored by compression or tension [J/kg].
  template <typename Number>
  Number stored_energy(const Number &density) const
  {
    const Number floor(cavitation_density_);
    const Number liquid_density = std::max(density, floor);
    const Number x = Number(density_) / liquid_density;
    const Number liquid =
      ((power(liquid_density) * x - Number(1.)) / (exponent_ - 1.) + x -
       Number(1.)) *
      (factor_ / density_);
    if (!(cavitation_density_ > 0.))
      return liquid;
    const Number void_energy =
      (Number(1. / cavitation_density_) - Number(1.) / density) *
      least_pressure_;
    return liquid + select_less(density, floor, void_energy, Number(0.));
  }

  /// Density of the liquid at a pressure [kg/m^3].
  double density_at(const double pressure) const
  {
    return density_ * std::pow(1. + pressure / factor_, 1. / exponent_);
  }

  /// Void fraction of the volume [-].
  double void_fraction(double density) const;

private:
  /// (rho / rho_0)^n.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number power(const Number &density) const
  {
    return exponential(logarithm(density * (1. / density_)) * exponent_);
  }

  double density_;
  double exponent_;
  double factor_; ///< B [Pa]
  double least_pressure_;
  double cavitation_density_ = 0.;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/cold_curve.h>

namespace contrecoup
{
/**
 * Products mixed with air that is so dilute that the exponentials of the cold
 * curve vanish: what MieGrueneisen::jwl_in_air() is there, to the last bit, see
 * MieGrueneisen::is_dilute(). A line of subcells takes a tenth less time, as
 * no selection by lane is necessary. Arguments are as in IdealGas.
 */
class DiluteMixture
{
public:
  static constexpr bool has_products = true;

  /// @param curve of products in air
  explicit DiluteMixture(const ColdCurve &curve)
    : curve_(curve)
  {}

  /// Internal energy per volume rho e [J/m^3].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number
  internal_energy_density(const Number & /*density*/,
                          const Number &pressure,
                          const Number &products) const
  {
    return curve_.mixed_dilute(products).inverse_omega * pressure;
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
    const auto mixed = curve_.mixed_dilute(products);
    internal_energy_density = mixed.inverse_omega * pressure;
    sound_speed_squared =
      (mixed.omega + 1.) * pressure * (Number(1.) / density);
  }

private:
  ColdCurve curve_;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/cold_curve.h>
#include <contrecoup/materials/dilute_mixture.h>
#include <contrecoup/materials/traced_air.h>

namespace contrecoup
{
/**
 * Mie-Grueneisen equation of state on a cold curve, with constants set at run
 * time:
 *
 *   p = p_c(rho, Y) + omega(Y) rho (e - e_c(rho, Y)),
 *   p_c = -p_inf + w (A exp(-R1 V) + B exp(-R2 V)),
 *   e_c = p_inf / rho + w (A/R1 exp(-R1 V) + B/R2 exp(-R2 V)) / rho_0,
 *
 * with V = rho_0 / rho. It covers the stiffened gas (w = 0), pure JWL (w = 1),
 * and a mixture of JWL products of mass fraction Y with air, where w = Y cv_p
 * / (Y cv_p + (1 - Y) cv_a) and omega = omega_a + w (omega_p - omega_a), so
 * that p is linear in e. Since de_c = -p_c d(1/rho), the sound speed at fixed
 * Y, c^2 = dp/drho|_e + p/rho^2 dp/de|_rho, is
 *
 *   c^2 = p_c'(rho) + omega (1 + omega) (e - e_c)
 *       = p_c'(rho) + (1 + omega) (p - p_c) / rho.
 *
 * With A, B >= 0 both terms are positive on {rho > 0, e > e_c}, and this set
 * is convex at fixed Y since (rho e_c)'' = p_c' / rho >= 0: fluxes between
 * products and thin gas rest on this, and it is the admissible set. Pure JWL
 * with B < 0 admits all states with c^2 > 0 instead: published problems have
 * some below the cold curve, others above it have no real sound speed. That set
 * need not be convex.
 *
 * Arguments are as in IdealGas. Y is clipped to [0, 1]. Where the exponentials
 * vanish, a group of lanes skips them (see ColdCurve).
 */
class MieGrueneisen
{
public:
  static constexpr bool has_products = true;

  /// p = (gamma - 1) rho e - gamma p_infinity. @p gas_constant [J/(kg K)]
  /// sets c_v = R / (gamma - 1) for the temperature.
  static MieGrueneisen stiffened_gas(double gamma,
                                     double p_infinity,
                                     double gas_constant = 287.05287);

  /// Pure products, whatever Y.
  static MieGrueneisen jwl(const JwlParameters &products);

  /// Products mixed with an ideal gas that has @p gamma_air and @p
  /// gas_constant.
  static MieGrueneisen jwl_in_air(const JwlParameters &products,
                                  double gamma_air = 1.4,
                                  double gas_constant = 287.05287);

  /// Whether a gas whose lanes have at most this density and mass fraction of
  /// products behaves as air(), to the last bit.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE bool is_air(const Number &density,
                                    const Number &products) const
  {
    return curve_.is_air(density, products);
  }
  TracedAir air() const
  {
    return TracedAir(curve_.base_omega());
  }

  /// Whether a gas whose lanes have at most this density behaves as dilute(),
  /// to the last bit.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE bool is_dilute(const Number &density) const
  {
    return curve_.is_dilute(density);
  }
  DiluteMixture dilute() const
  {
    return DiluteMixture(curve_);
  }

  /// Whether the state depends on the mass fraction of products.
  bool uses_products() const
  {
    return curve_.uses_products();
  }

  /// Pressure [Pa].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number pressure(const Number &density,
                                        const Number &internal_energy_density,
                                        const Number &products) const
  {
    const ColdState<Number> cold = curve_.at(density, products);
    return pressure_at(cold, internal_energy_density);
  }

  /// Internal energy density rho e [J/m^3].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number
  internal_energy_density(const Number &density,
                          const Number &pressure,
                          const Number &products) const
  {
    const ColdState<Number> cold = curve_.at(density, products);
    return energy_density_at(cold, pressure);
  }

  /// Squared sound speed [m^2/s^2].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number sound_speed_squared(const Number &density,
                                                   const Number &pressure,
                                                   const Number &products) const
  {
    const ColdState<Number> cold = curve_.at(density, products);
    return sound_speed_squared_at(cold, density, pressure);
  }

  /// rho e_c [J/m^3] of pure products for any Y.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number
  cold_energy_density(const Number &density, const Number & /*products*/) const
  {
    return curve_.energy_density_of_products(density, 0.);
  }

  /// Lower bound of the admissible rho e [J/m^3]. Pure JWL with B < 0: where
  /// c^2 = 0. Otherwise cold_energy_density(), which keeps the set {rho > 0,
  /// rho e > bound} convex in (rho, rho u, rho E, rho Y) and lies above rho e_c
  /// of the mixture; in air below 100 kg/m^3 the difference is less than 2
  /// J/kg.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number
  least_energy_density(const Number &density, const Number & /*products*/) const
  {
    return curve_.energy_density_of_products(density, slope_share_);
  }

  /// Temperature (e - e_c) / c_v [K].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number temperature(const Number &density,
                                           const Number &pressure,
                                           const Number &products) const
  {
    const ColdState<Number> cold = curve_.at(density, products);
    return (pressure - cold.pressure) * cold.inverse_omega /
           (density * curve_.specific_heat(products));
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
    const ColdState<Number> cold = curve_.at(density, products);
    pressure = pressure_at(cold, internal_energy_density);
    sound_speed_squared = sound_speed_squared_at(cold, density, pressure);
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
    const ColdState<Number> cold = curve_.at(density, products);
    internal_energy_density = energy_density_at(cold, pressure);
    sound_speed_squared = sound_speed_squared_at(cold, density, pressure);
  }

private:
  /// @param slope_share see slope_share_
  explicit MieGrueneisen(const ColdCurve &curve, const double slope_share = 0.)
    : curve_(curve)
    , slope_share_(slope_share)
  {}

  template <typename Number>
  static DEAL_II_ALWAYS_INLINE Number
  pressure_at(const ColdState<Number> &cold,
              const Number &internal_energy_density)
  {
    return cold.pressure +
           cold.omega * (internal_energy_density - cold.energy_density);
  }

  template <typename Number>
  static DEAL_II_ALWAYS_INLINE Number
  energy_density_at(const ColdState<Number> &cold, const Number &pressure)
  {
    return cold.energy_density +
           cold.inverse_omega * (pressure - cold.pressure);
  }

  template <typename Number>
  static DEAL_II_ALWAYS_INLINE Number
  sound_speed_squared_at(const ColdState<Number> &cold,
                         const Number &density,
                         const Number &pressure)
  {
    return cold.slope + (cold.omega + 1.) * (pressure - cold.pressure) *
                          (Number(1.) / density);
  }

  ColdCurve curve_;
  /// Ratio of e_c - least e to p_c' [-].
  double slope_share_;
};
} // namespace contrecoup

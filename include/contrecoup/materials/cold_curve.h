// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/exponential.h>
#include <contrecoup/materials/jwl_parameters.h>

#include <limits>

namespace contrecoup
{
/// Largest exponent R V that is evaluated: exp(-90) = 8e-40.
constexpr double largest_cold_exponent = 90.;

/// Cold curve and Grueneisen coefficient at one density and mass fraction.
template <typename Number>
struct ColdState
{
  Number pressure;       ///< p_c [Pa]
  Number energy_density; ///< rho e_c [J/m^3]
  Number slope;          ///< dp_c/drho at fixed mass fraction [m^2/s^2]
  Number omega;          ///< [-]
  Number inverse_omega;  ///< [-]
};

/// Mass fraction of products [-] up to which gas in air is taken for air: what
/// it adds to the Grueneisen coefficient is lost in rounding.
template <typename Number>
inline constexpr double
  negligible_products = std::numeric_limits<Number>::epsilon() / 8.;
template <typename Scalar, std::size_t width>
inline constexpr double negligible_products<LaneGroup<Scalar, width>> =
  negligible_products<Scalar>;

/**
 * Cold curve, Grueneisen coefficient and specific heat of MieGrueneisen, with
 * constants set at run time. Exponentials below 1e-39 count as zero (for TNT:
 * below rho_0 / 100). A lane group that lies entirely there, or that holds no
 * products, skips the exponentials.
 */
class ColdCurve
{
public:
  /// p_c = -p_infinity, omega = gamma - 1, c_v = R / omega.
  static ColdCurve
  stiffened_gas(double gamma, double p_infinity, double gas_constant);

  /// Pure products, whatever the mass fraction.
  static ColdCurve jwl(const JwlParameters &products);

  /// Products mixed with air, weighted by the mass fraction of products.
  static ColdCurve jwl_in_air(const JwlParameters &products,
                              double gamma_air,
                              double gas_constant);

  /// Whether the state depends on the mass fraction.
  bool uses_products() const
  {
    return uses_products_;
  }

  /// Cold state at density [kg/m^3] and mass fraction [-], clipped to [0, 1].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE ColdState<Number> at(const Number &density,
                                             const Number &products) const
  {
    ColdState<Number> cold;
    cold.pressure = Number(-p_infinity_);
    cold.energy_density = Number(p_infinity_);
    cold.slope = Number(0.);

    const Number weight = mix(products, cold);
    const Number dense =
      select_less(Number(dilute_density_), density, weight, Number(0.));
    if (any_less(Number(0.), dense))
      add_exponentials(density, dense, cold);
    return cold;
  }

  /// rho (e_c - @p slope_share dp_c/drho) [J/m^3] of products alone.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number
  energy_density_of_products(const Number &density,
                             const double slope_share) const
  {
    if (!any_less(Number(dilute_density_), density))
      return Number(p_infinity_);
    const ColdState<Number> cold = at(density, Number(1.));
    return cold.energy_density - density * slope_share * cold.slope;
  }

  /// Whether lanes that have at most this density [kg/m^3] hold products and
  /// air, for which mixed_dilute() is the cold state.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE bool is_dilute(const Number &density) const
  {
    return uses_products_ && !any_less(Number(dilute_density_), density);
  }

  /// Cold state of products in air where the exponentials vanish.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE ColdState<Number>
  mixed_dilute(const Number &products) const
  {
    ColdState<Number> cold = {};
    mix_products(products, cold);
    return cold;
  }

  /// Whether a gas whose lanes have at most this density and mass fraction of
  /// products is an ideal gas of Grueneisen coefficient base_omega().
  template <typename Number>
  DEAL_II_ALWAYS_INLINE bool is_air(const Number &density,
                                    const Number &products) const
  {
    return is_dilute(density) &&
           !any_less(Number(negligible_products<Number>), products);
  }
  /// omega without products [-].
  double base_omega() const
  {
    return base_omega_;
  }

  /// Specific heat c_v of the mixture [J/(kg K)].
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number specific_heat(const Number &products) const
  {
    return uses_products_ ? mixed_specific_heat(products)
                          : Number(base_specific_heat_);
  }

private:
  template <typename Number>
  static DEAL_II_ALWAYS_INLINE Number clip(const Number &products)
  {
    return std::min(std::max(products, Number(0.)), Number(1.));
  }

  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number mixed_specific_heat(const Number &products) const
  {
    return clip(products) * specific_heat_difference_ + base_specific_heat_;
  }

  /// Sets omega, and returns the weight w of the exponentials.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number mix(const Number &products,
                                   ColdState<Number> &cold) const
  {
    if (uses_products_ &&
        any_less(Number(negligible_products<Number>), products))
      return mix_products(products, cold);
    cold.omega = Number(base_omega_);
    cold.inverse_omega = Number(inverse_base_omega_);
    return Number(constant_weight_);
  }

  /// Likewise, of products mixed with air: omega is gas constant over specific
  /// heat of the mixture.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number mix_products(const Number &products,
                                            ColdState<Number> &cold) const
  {
    const Number negligible(negligible_products<Number>);
    const Number clipped = clip(products);
    const Number specific_heat = mixed_specific_heat(products);
    const Number gas_constant =
      clipped * gas_constant_difference_ + base_gas_constant_;
    // One division for both: it takes longer than all other operations here.
    const Number inverse = Number(1.) / (specific_heat * gas_constant);
    const Number inverse_heat = gas_constant * inverse;
    cold.omega = select_less(negligible,
                             products,
                             Number(gas_constant * inverse_heat),
                             Number(base_omega_));
    cold.inverse_omega =
      select_less(negligible,
                  products,
                  Number(specific_heat * (specific_heat * inverse)),
                  Number(inverse_base_omega_));
    return select_less(negligible,
                       products,
                       Number(clipped * specific_heat_products_ * inverse_heat),
                       Number(0.));
  }

  /// Adds the exponential terms with the @p weight.
  template <typename Number>
  void add_exponentials(const Number &density,
                        const Number &weight,
                        ColdState<Number> &cold) const
  {
    const double reference = products_.reference_density;
    // Where the weight is zero, any finite value will do.
    const Number volume =
      Number(reference) / std::max(density, Number(dilute_density_));
    const Number first =
      weight * products_.A * exponential(Number(volume * -products_.R1));
    const Number second =
      weight * products_.B * exponential(Number(volume * -products_.R2));

    cold.pressure = cold.pressure + (first + second);
    cold.energy_density =
      cold.energy_density +
      density * (1. / reference) * (first * inverse_R1_ + second * inverse_R2_);
    cold.slope = volume * volume * (1. / reference) *
                 (first * products_.R1 + second * products_.R2);
  }

  JwlParameters products_;
  bool uses_products_ = false;
  double p_infinity_ = 0.;
  double dilute_density_ = 0.;
  double constant_weight_ = 0.; ///< w if Y is not used, or without products
  double base_omega_ = 0.;      ///< omega without products
  double inverse_base_omega_ = 0.;
  double base_gas_constant_ = 0.;
  double gas_constant_difference_ = 0.; ///< of products and air
  double base_specific_heat_ = 1.;
  double specific_heat_products_ = 1.;
  double specific_heat_difference_ = 0.;
  double inverse_R1_ = 1.;
  double inverse_R2_ = 1.;
};
} // namespace contrecoup

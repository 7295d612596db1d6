// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/materials/cold_curve.h>

#include <algorithm>
#include <limits>

namespace contrecoup
{
ColdCurve ColdCurve::stiffened_gas(const double gamma,
                                   const double p_infinity,
                                   const double gas_constant)
{
  ColdCurve curve;
  curve.p_infinity_ = p_infinity;
  curve.dilute_density_ = std::numeric_limits<float>::max();
  curve.base_omega_ = gamma - 1.;
  curve.inverse_base_omega_ = 1. / curve.base_omega_;
  curve.base_specific_heat_ = gas_constant / curve.base_omega_;
  return curve;
}

ColdCurve ColdCurve::jwl(const JwlParameters &products)
{
  ColdCurve curve;
  curve.products_ = products;
  curve.dilute_density_ = products.reference_density *
                          std::min(products.R1, products.R2) /
                          largest_cold_exponent;
  curve.constant_weight_ = 1.;
  curve.base_omega_ = products.omega;
  curve.inverse_base_omega_ = 1. / products.omega;
  curve.base_specific_heat_ = products.specific_heat;
  curve.inverse_R1_ = 1. / products.R1;
  curve.inverse_R2_ = 1. / products.R2;
  return curve;
}

ColdCurve ColdCurve::jwl_in_air(const JwlParameters &products,
                                const double gamma_air,
                                const double gas_constant)
{
  ColdCurve curve = jwl(products);
  curve.uses_products_ = true;
  curve.constant_weight_ = 0.;
  curve.base_omega_ = gamma_air - 1.;
  curve.inverse_base_omega_ = 1. / curve.base_omega_;
  curve.base_gas_constant_ = gas_constant;
  curve.gas_constant_difference_ =
    products.omega * products.specific_heat - gas_constant;
  curve.base_specific_heat_ = gas_constant / curve.base_omega_;
  curve.specific_heat_products_ = products.specific_heat;
  curve.specific_heat_difference_ =
    products.specific_heat - curve.base_specific_heat_;
  return curve;
}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/materials/mie_grueneisen.h>

namespace contrecoup
{
MieGrueneisen MieGrueneisen::stiffened_gas(const double gamma,
                                           const double p_infinity,
                                           const double gas_constant)
{
  return MieGrueneisen(
    ColdCurve::stiffened_gas(gamma, p_infinity, gas_constant));
}

MieGrueneisen MieGrueneisen::jwl(const JwlParameters &products)
{
  const double slope_share =
    products.B < 0. ? 1. / (products.omega * (1. + products.omega)) : 0.;
  return MieGrueneisen(ColdCurve::jwl(products), slope_share);
}

MieGrueneisen MieGrueneisen::jwl_in_air(const JwlParameters &products,
                                        const double gamma_air,
                                        const double gas_constant)
{
  return MieGrueneisen(
    ColdCurve::jwl_in_air(products, gamma_air, gas_constant));
}
} // namespace contrecoup

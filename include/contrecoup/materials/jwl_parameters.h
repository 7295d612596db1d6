// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/// Constants of a Jones-Wilkins-Lee equation of state of detonation
/// products, p = A (1 - omega/(R1 V)) exp(-R1 V) + B (1 - omega/(R2 V))
/// exp(-R2 V) + omega rho e with V = rho_0 / rho.
struct JwlParameters
{
  double A = 0.;                 ///< [Pa], not negative
  double B = 0.;                 ///< [Pa], if negative see jwl_check.h
  double R1 = 1.;                ///< [-]
  double R2 = 1.;                ///< [-]
  double omega = 0.;             ///< [-]
  double reference_density = 1.; ///< rho_0 [kg/m^3]
  double energy_density = 0.;    ///< E_0 = rho_0 e_0 [J/m^3]
  double specific_heat = 1.;     ///< c_v of the products [J/(kg K)]
};
} // namespace contrecoup

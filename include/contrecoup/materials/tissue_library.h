// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/tissues.h>
#include <contrecoup/materials/gas_filled.h>

#include <string>
#include <vector>

namespace contrecoup
{
/**
 * Properties of a tissue, an isotropic solid that is viscoelastic in shear:
 * G(t) = G_inf + (G_0 - G_inf) exp(-t / tau). Elastic tissues have G_inf =
 * G_0.
 */
struct TissueProperties
{
  Tissue tissue;
  double density;             ///< [kg/m^3]
  double bulk_modulus;        ///< K [Pa]
  double instantaneous_shear; ///< G_0 [Pa]
  double long_term_shear;     ///< G_inf [Pa]
  double relaxation_time;     ///< tau [s]; 0 for elastic tissues
  std::string source;
  GasFilling gas = {}; ///< in lungs, but not in the paper's

  /// P-wave speed sqrt((K + 4/3 G_0) / rho) [m/s].
  double dilatational_speed() const;

  /// Shear wave speed sqrt(G_0 / rho) [m/s].
  double shear_speed() const;
};

/// Names of the property sets: "paper" is table 1 of Tan, Saunders and Bagchi
/// (COUPLED PROBLEMS 2017); "physiological" has wave speeds measured on
/// tissue, recalled without access to the originals, as each source says;
/// "paper with aerated lung" is the first with the lung of the second, whose
/// air resists compression: a lung of the paper's constant bulk modulus, 42
/// kPa, is crushed by blasts that injure.
const std::vector<std::string> &tissue_set_names();

/**
 * Properties of a tissue.
 *
 * The paper gives "G0 = 49 kPa, G1 = 33 kPa, tau = 6 ms" for the brain; G1 is
 * taken as the relaxing part, so that G_inf = 16 kPa. The paper has no
 * cerebrospinal fluid (its brain properties are used, as in the paper), and no
 * skin, heart and liver (its soft tissue is used). Surrogate materials are the
 * same in all sets.
 * @throws InputError for an unknown set or a tissue without properties
 */
const TissueProperties &find_tissue_properties(const std::string &set,
                                               Tissue tissue);
} // namespace contrecoup

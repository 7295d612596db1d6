// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/tissues.h>
#include <contrecoup/materials/gas_filled.h>

#include <string>
#include <vector>

namespace contrecoup
{
/**
 * A tissue as an isotropic solid, viscoelastic in shear:
 * G(t) = G_inf + (G_0 - G_inf) exp(-t / tau). Elastic ones have G_inf = G_0.
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
  GasFilling gas = {}; ///< the lung of the physiological set has some

  /// Speed of dilatational waves, sqrt((K + 4/3 G_0) / rho) [m/s].
  double dilatational_speed() const;

  /// Speed of shear waves, sqrt(G_0 / rho) [m/s].
  double shear_speed() const;
};

/// Names of the sets of properties: "paper" is table 1 of Tan, Saunders and
/// Bagchi (COUPLED PROBLEMS 2017), "physiological" has the wave speeds that
/// were measured on tissue. Figures of the second set were recalled, and
/// their originals not seen; each source says so.
const std::vector<std::string> &tissue_set_names();

/**
 * The properties of a tissue.
 *
 * The paper gives "G0 = 49 kPa, G1 = 33 kPa, tau = 6 ms" for the brain; G1 is
 * taken for the branch that relaxes, so that G_inf = 16 kPa. It has neither
 * fluid (the brain's properties stand for it, as in the paper), nor skin,
 * heart and liver (its soft tissue), nor the materials of surrogates, which
 * are the same in all sets.
 * @throws InputError for an unknown set or a tissue without properties
 */
const TissueProperties &find_tissue_properties(const std::string &set,
                                               Tissue tissue);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/**
 * Peak overpressure of a simple blast wave that half of the exposed men
 * survive for 24 h [Pa]: 61.5 psi (1 + 6.76 T^-1.064), with the duration T in
 * ms scaled to 70 kg and sea level. The overpressure is the load on the chest:
 * reflected in front of a wall, otherwise side-on plus dynamic pressure (I. G.
 * Bowen, E. R. Fletcher, D. R. Richmond, DASA-2113, 1968; curve as recalled).
 * Not valid for complex waves; use chest_wall_response() for those.
 *
 * @param duration of the positive phase [s], positive
 * @param mass of the body [kg]
 * @param ambient_pressure [Pa]
 */
double lung_median_lethal_overpressure(const double duration,
                                       const double mass,
                                       const double ambient_pressure);

/// Threshold of lung injury [Pa]: a fifth of lung_median_lethal_overpressure()
/// (Bowen et al. 1968, as recalled).
double lung_threshold_overpressure(const double duration,
                                   const double mass,
                                   const double ambient_pressure);

/**
 * Probability of eardrum rupture [-] at a peak overpressure [Pa] at the ear:
 * normal distribution of ln p, probit -12.6 + 1.524 ln p, median 104 kPa (fit
 * as recalled; a median of 100 kPa and a threshold of 35 kPa are in use, D. R.
 * Richmond et al., Ann. Otol. Rhinol. Laryngol. 98 (1989) 35-41).
 */
double eardrum_rupture_probability(const double overpressure);
} // namespace contrecoup

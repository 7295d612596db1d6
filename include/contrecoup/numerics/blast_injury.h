// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/**
 * Peak overpressure of a simple blast wave that half of the men exposed survive
 * for a day [Pa]: 61.5 psi (1 + 6.76 T^-1.064) with T the duration in ms
 * scaled to 70 kg and sea level; the overpressure is what the chest is loaded
 * with: reflected, before a wall, or side-on plus dynamic (I. G. Bowen, E. R.
 * Fletcher, D. R. Richmond, DASA-2113, 1968; curve as recalled). Not for
 * complex waves, which the chest wall model is for.
 *
 * @param duration of the positive phase [s], above 0
 * @param mass of the body [kg]
 * @param ambient_pressure [Pa]
 */
double lung_median_lethal_overpressure(const double duration,
                                       const double mass,
                                       const double ambient_pressure);

/// Overpressure at which lungs begin to be hurt [Pa]: a fifth of
/// lung_median_lethal_overpressure() (Bowen et al. 1968, as recalled).
double lung_threshold_overpressure(const double duration,
                                   const double mass,
                                   const double ambient_pressure);

/**
 * Part of the eardrums that rupture [-] at a peak overpressure [Pa] at the ear:
 * a normal distribution of ln p, probit -12.6 + 1.524 ln p, with half at 104
 * kPa (fit as recalled; a P50 of 100 kPa and a threshold of 35 kPa are in use,
 * D. R. Richmond et al., Ann. Otol. Rhinol. Laryngol. 98 (1989) 35-41).
 */
double eardrum_rupture_probability(const double overpressure);
} // namespace contrecoup

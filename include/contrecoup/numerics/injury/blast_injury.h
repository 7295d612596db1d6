// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/// Pressure of the standard atmosphere [Pa].
constexpr double sea_level_pressure = 101325.;

/**
 * Peak overpressure of a simple blast wave that half of the exposed men
 * survive for 24 h [Pa]: 61.5 psi (1 + 6.76 T^-1.064), with the duration T in
 * ms scaled to 70 kg and sea level (I. G. Bowen, E. R. Fletcher, D. R.
 * Richmond, DASA-2113, 1968, as given by McMichael, LLNL-TR-468242, 2011; for
 * 3 to 5 ms UFC 3-340-02, table 1-1, has 130 to 180 psi, recalled). The curve
 * is defined by the free field, not by the pressure on the skin: see
 * standing_load() and, near a wall, reflected_overpressure(). Not valid for
 * complex waves; use chest_wall_response() for those.
 *
 * @param duration of the positive phase [s], positive
 * @param mass of the body [kg]
 * @param ambient_pressure [Pa]
 */
double lung_median_lethal_overpressure(const double duration,
                                       const double mass,
                                       const double ambient_pressure);

/**
 * Probability of death within 24 h by lung injury [-] under a load that is
 * @p exposure times lung_median_lethal_overpressure(): normal distribution of
 * the logarithm with a standard deviation of 0.1788 (same sources). A load of
 * 0.66 kills 1 %.
 */
double lung_lethality_probability(const double exposure);

/// Dynamic pressure [Pa] behind a shock of the given @p overpressure [Pa] in
/// air of @p ambient pressure [Pa] with gamma = 1.4: 5/2 p^2 / (7 p0 + p)
/// (Rankine-Hugoniot).
double dynamic_pressure(const double overpressure, const double ambient);

/// Bowen's load of a person who stands in the open [Pa]: overpressure and
/// dynamic pressure of the incident wave, as if nobody were there.
double standing_load(const double overpressure, const double ambient);

/**
 * Bowen's load where the gas moves as it does at one place and instant [Pa]:
 * @p overpressure and the @p dynamic pressure rho v^2 / 2 [Pa], of which no
 * more counts than dynamic_pressure(), that of a shock, because the denser
 * products of an explosive carry more. In a free wave this is standing_load(),
 * before a wall, where the gas rests, the reflected overpressure, which Bowen
 * takes there. 0 below the ambient pressure.
 */
double load_in_flow(const double overpressure,
                    const double dynamic,
                    const double ambient);

/// Whether people live at that ambient pressure [Pa]: 45 to 115 kPa.
bool is_habitable(const double ambient);

/**
 * Probability of eardrum rupture [-] at a peak overpressure [Pa] at the ear:
 * normal distribution of ln p, probit -12.6 + 1.524 ln p with p in Pa (TNO,
 * Methods for the Determination of Possible Damage, CPR 16E, 1992). 50 % at
 * 15.0 psi and 99 % at 69 psi; NASA-STD-8719.12A, table E-1 (after DESR
 * 6055.09), has 15.0 and 74.4 psi.
 */
double eardrum_rupture_probability(const double overpressure);
} // namespace contrecoup

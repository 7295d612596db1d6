// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <vector>

namespace contrecoup
{
/// What the load on a place of the skin would do to what may be there.
struct LoadInjury
{
  double peak = 0.;                ///< overpressure [Pa]
  double positive_phase = 0.;      ///< duration of the first one [s]
  double chest_wall_velocity = 0.; ///< largest, inward, of a chest wall [m/s]
  double lung_exposure = 0.;       ///< peak over that which half survive [-]
  double eardrum_rupture = 0.;     ///< probability, of an ear [-]
};

/**
 * Duration of the first positive phase of an overpressure [s]: from when it
 * reaches a twentieth of its peak until it is first back at zero, or to the
 * end; 0 of one that is never above zero.
 *
 * @param times increasing [s]
 * @param overpressures at these times [Pa]
 */
double first_positive_phase(const std::vector<double> &times,
                            const std::vector<double> &overpressures);

/**
 * What men suffer from a load at sea level, by chest_wall_response(),
 * lung_median_lethal_overpressure() for the first positive phase, and
 * eardrum_rupture_probability(): each as if a chest, or an ear, were there.
 *
 * @param times increasing [s]
 * @param overpressures at these times, straight between them [Pa]
 * @param body_mass [kg]
 * @throws InputError for times that do not increase, or as many overpressures
 * as times are missing
 */
LoadInjury load_injury(const std::vector<double> &times,
                       const std::vector<double> &overpressures,
                       const double body_mass);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <vector>

namespace contrecoup
{
/// Pressure pulse on the skin.
struct PressurePulse
{
  double peak = 0.;     ///< peak overpressure [Pa]
  double duration = 0.; ///< duration of the positive phase [s]
  /// Whether the positive phase continues where the history ends: then what
  /// follows from its duration is a lower limit.
  bool is_cut = false;
};

/// Injuries that a load on the skin would cause.
struct LoadInjury
{
  PressurePulse pulse;
  double chest_wall_velocity = 0.; ///< largest inward velocity [m/s]
  double lung_exposure = 0.;       ///< peak over median lethal peak [-]
  double eardrum_rupture = 0.;     ///< probability [-]
  /// Whether the velocity is a lower limit: the history ends before the load
  /// arrives, or while the chest wall is at its fastest. The rest of a wave
  /// that is cut off later does not move the wall faster.
  bool is_velocity_cut = false;
};

/// Injuries by a wave to a person who stands in the air that it passes.
struct AirInjury
{
  double lung_exposure = 0.;   ///< load over median lethal load [-]
  double lung_lethality = 0.;  ///< probability [-]
  double eardrum_rupture = 0.; ///< probability [-]
};

/**
 * The same at a place in the air, as if nobody were there, by
 * lung_median_lethal_overpressure(), lung_lethality_probability() and
 * eardrum_rupture_probability(). Zero where there is no positive phase.
 *
 * @param pulse peak overpressure and positive phase
 * @param load largest load_in_flow() [Pa]
 * @param ambient pressure [Pa]
 * @param body_mass [kg]
 */
AirInjury air_injury(const PressurePulse &pulse,
                     const double load,
                     const double ambient,
                     const double body_mass);

/**
 * Peak of an overpressure history and its first positive phase: from reaching
 * 5 % of the peak until the first return to zero, or until the end; none if it
 * is never positive.
 *
 * @param times increasing [s]
 * @param overpressures at these times [Pa]
 */
PressurePulse first_pulse(const std::vector<double> &times,
                          const std::vector<double> &overpressures);

/**
 * Injuries of a man by a load at sea level, from chest_wall_response() of the
 * history, lung_median_lethal_overpressure() and eardrum_rupture_probability()
 * of the pulse, as if chest or ear were at this place.
 *
 * @param times increasing [s]
 * @param overpressures at these times, linear in between [Pa]
 * @param pulse peak and positive phase of the load
 * @param body_mass [kg]
 * @throws InputError for times that do not increase, or when numbers of times
 * and overpressures differ
 */
LoadInjury load_injury(const std::vector<double> &times,
                       const std::vector<double> &overpressures,
                       const PressurePulse &pulse,
                       const double body_mass);

/// The same for the first_pulse() of the history.
LoadInjury load_injury(const std::vector<double> &times,
                       const std::vector<double> &overpressures,
                       const double body_mass);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/**
 * Overpressure over time of a blast wave at a place, after F. G. Friedlander,
 * Proceedings of the Royal Society A 186 (1946) 322:
 * peak (1 - s / duration) exp(-decay s / duration), s = time - arrival.
 */
struct Friedlander
{
  double arrival = 0.;  ///< [s]
  double peak = 0.;     ///< [Pa]
  double duration = 1.; ///< of the positive phase, above 0 [s]
  double decay = 0.;    ///< at least 0 [-]

  /// Overpressure [Pa]; 0 before the arrival, and after the positive phase
  /// unless @p with_negative_phase.
  double value(double time, bool with_negative_phase = false) const;

  /// Impulse of the positive phase [Pa s].
  double impulse() const;
};

/**
 * The pulse with a peak [Pa], duration [s] and impulse of the positive phase
 * [Pa s]. An impulse of more than half of peak times duration, which no decay
 * has, makes the duration longer.
 * @throws InputError unless all three are above 0
 */
Friedlander
friedlander_pulse(double arrival, double peak, double duration, double impulse);

/**
 * Peak overpressure [Pa] at a rigid wall that a shock of the given
 * overpressure [Pa] meets head on, in air of the @p ambient pressure [Pa] with
 * gamma = 1.4 (Rankine-Hugoniot).
 */
double reflected_overpressure(double overpressure, double ambient);

/**
 * Overpressure [Pa] on a facet: reflected cos^2 + incident (1 + cos - 2 cos^2)
 * where @p cosine, between the facet's outer normal and the way to the charge,
 * is above 0, the incident one elsewhere; after G. Randers-Pehrson and
 * K. A. Bannister, ARL-TR-1310 (1997).
 */
double pressure_at_angle(double incident, double reflected, double cosine);
} // namespace contrecoup

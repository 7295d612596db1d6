// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/**
 * Overpressure history of a blast wave at a point, after F. G. Friedlander,
 * Proceedings of the Royal Society A 186 (1946) 322: peak (1 - s / duration)
 * exp(-decay s / duration), s = time - arrival.
 */
struct Friedlander
{
  double arrival = 0.;  ///< [s]
  double peak = 0.;     ///< [Pa]
  double duration = 1.; ///< of the positive phase, positive [s]
  double decay = 0.;    ///< not negative [-]

  /// Overpressure [Pa]; 0 before arrival and, unless @p with_negative_phase,
  /// after the positive phase.
  double value(double time, bool with_negative_phase = false) const;

  /// Impulse of the positive phase [Pa s].
  double impulse() const;
};

/**
 * Pulse with a given peak [Pa], duration [s] and impulse of the positive phase
 * [Pa s]. If the impulse exceeds half of peak times duration, which no decay
 * gives, the duration is increased.
 * @throws InputError unless all three are positive
 */
Friedlander
friedlander_pulse(double arrival, double peak, double duration, double impulse);

/**
 * Reflected overpressure [Pa] at a rigid wall under normal incidence of a
 * shock with the given overpressure [Pa], in air of @p ambient pressure [Pa]
 * with gamma = 1.4 (Rankine-Hugoniot).
 */
double reflected_overpressure(double overpressure, double ambient);

/**
 * Overpressure [Pa] on a facet: reflected cos^2 + incident (1 + cos - 2 cos^2)
 * where @p cosine, between the outward normal and the direction to the charge,
 * is positive, otherwise the incident overpressure; after G. Randers-Pehrson
 * and K. A. Bannister, ARL-TR-1310 (1997).
 */
double pressure_at_angle(double incident, double reflected, double cosine);
} // namespace contrecoup

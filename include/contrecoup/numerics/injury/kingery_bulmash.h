// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
/// Tabulated quantities of a blast wave.
enum class BlastQuantity
{
  overpressure,           ///< peak of the incident wave [Pa]
  reflected_overpressure, ///< peak at a rigid wall, normal incidence [Pa]
  impulse,                ///< positive-phase impulse, incident [Pa s]
  reflected_impulse,      ///< positive-phase impulse, reflected [Pa s]
  arrival,                ///< time from the detonation [s]
  duration,               ///< of the positive phase [s]
  shock_speed             ///< of the front [m/s]
};

/**
 * Blast waves of TNT in air at sea level, fitted to measurements: the standard
 * reference for free-field explosions.
 *
 * "spherical" (free air) and "hemispherical" (charge on rigid ground) are the
 * polynomials of C. Kingery and G. Bulmash, ARBRL-TR-02555 (1984), in metric
 * units: T = log10 Z, U = K0 + K1 T, log10 Y = sum_i C_i U^i with the scaled
 * distance Z [m/kg^(1/3)]. Printed and public copies disagree; these
 * coefficients agree with the imperial set, are continuous between their
 * pieces within 2 %, and satisfy Rankine-Hugoniot. "swisdak" are the simpler
 * fits to the hemispherical data by M. Swisdak, ADA526744 (1994), in powers of
 * ln Z. Durations are not monotone below Z = 2.3.
 */
class KingeryBulmash
{
public:
  /// Names of the sets of polynomials.
  static const std::vector<std::string> sets;

  /**
   * @param set one of @p sets
   * @param mass of TNT [kg], positive
   * @throws InputError for other values
   */
  KingeryBulmash(const std::string &set, double mass);

  /// Distance at the scaled distance 1 m/kg^(1/3) [m].
  double scaling_length() const
  {
    return scaling_length_;
  }

  /// Whether a quantity is tabulated at @p distance from the charge [m].
  bool covers(BlastQuantity quantity, double distance) const;

  /// @throws InputError unless covers()
  double value(BlastQuantity quantity, double distance) const;

private:
  struct Piece;
  struct Set;
  static const std::vector<Set> tables;

  const Piece *find(BlastQuantity quantity, double distance) const;

  const Set *set_;
  double scaling_length_;
};
} // namespace contrecoup

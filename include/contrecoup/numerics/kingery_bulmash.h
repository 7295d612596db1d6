// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
/// What is tabulated of a blast wave.
enum class BlastQuantity
{
  overpressure,           ///< peak of the passing wave [Pa]
  reflected_overpressure, ///< peak at a rigid wall that it meets head on [Pa]
  impulse,                ///< positive-phase impulse of the passing wave [Pa s]
  reflected_impulse,      ///< the same at the wall [Pa s]
  arrival,                ///< time since the detonation [s]
  duration,               ///< of the positive phase [s]
  shock_speed             ///< of the front [m/s]
};

/**
 * The blast wave of TNT in air at sea level, as fitted to measurements: the
 * customary reference for free-field explosions.
 *
 * "spherical" (in free air) and "hemispherical" (charge on rigid ground) are
 * the polynomials of C. Kingery and G. Bulmash, ARBRL-TR-02555 (1984), in
 * metric units: T = log10 Z, U = K0 + K1 T, log10 Y = sum_i C_i U^i with the
 * scaled distance Z [m/kg^(1/3)]. Printed and public copies disagree; these
 * coefficients agree with the imperial set, join at the ends of their pieces
 * within 2 % and satisfy Rankine and Hugoniot. "swisdak" are the simpler
 * fits to the hemispherical ones by M. Swisdak, ADA526744 (1994), in powers
 * of ln Z. Durations are not monotone below Z = 2.3.
 */
class KingeryBulmash
{
public:
  /// The names of the sets of polynomials.
  static const std::vector<std::string> sets;

  /**
   * @param set one of @p sets
   * @param mass of TNT [kg], above 0
   * @throws InputError otherwise.
   */
  KingeryBulmash(const std::string &set, double mass);

  /// Distance [m] of the scaled distance 1 m/kg^(1/3).
  double scaling_length() const
  {
    return scaling_length_;
  }

  /// Whether there is a figure at @p distance [m] from the charge's centre.
  bool covers(BlastQuantity quantity, double distance) const;

  /// @throws InputError where there is none.
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

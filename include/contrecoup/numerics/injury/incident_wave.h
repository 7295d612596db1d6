// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/explosives.h>
#include <contrecoup/numerics/injury/expected_blast.h>
#include <contrecoup/numerics/injury/kingery_bulmash.h>

#include <string>

namespace contrecoup
{
/**
 * The incident blast wave of a bare charge at sea level, in free air or on the
 * ground, as it is known before a run: measured waves of TNT (KingeryBulmash,
 * "spherical" or "hemispherical") with the charge's TNT equivalence for
 * pressures and for impulses. Beyond the scaled distances of the tables, the
 * point source (ExpectedBlast) continues overpressure and arrival from the
 * values at their ends, and other quantities are not known. Unscaled it has 0.6
 * to 1.3 times the overpressure of the measurements and an arrival up to a
 * third too early, since it has no charge whose mass is to be moved.
 */
class IncidentWave
{
public:
  /// Largest height of a surface burst [m/kg^(1/3) of TNT], two radii of the
  /// charge: its products still drive the wave when the ground reflects it, and
  /// the reflection catches up with the front. In blast's axisymmetric runs of
  /// 0.5 kg of PETN, peaks at this height differ by at most 15 % from those of
  /// a charge on the ground, from surface_distance on.
  static constexpr double surface_height = 0.1;

  /// Least distance of the body from a surface burst in heights of the charge:
  /// nearer, the reflection may still be behind the front.
  static constexpr double surface_distance = 5.;

  /// Mass in free air with the wave of one on the ground: 2 above rigid
  /// ground, measured 1.8 (M. Swisdak, ADA526744, 1994).
  static constexpr double surface_mass = 1.8;

  /**
   * @param tnt equivalence of the explosive
   * @param mass of the charge [kg], positive
   * @param energy of the charge, of detonation and afterburn [J], positive
   * @param is_surface_burst whether the charge is on the ground
   * @throws InputError for other values
   */
  IncidentWave(const TntEquivalence &tnt,
               double mass,
               double energy,
               bool is_surface_burst = false);

  /// Whether the ground's reflection is one with the incident wave of a charge
  /// of @p tnt_mass [kg], @p height above rigid ground [m], at @p distance [m].
  static bool is_surface_burst(double tnt_mass, double height, double distance);

  /// Radius of a sphere of TNT whose pressures these are [m].
  double charge_radius() const;

  /// The set of KingeryBulmash for a burst.
  static std::string tables_for(bool is_surface_burst);

  /// Whether the tables have the quantity at @p distance [m].
  bool is_tabulated(BlastQuantity quantity, double distance) const;

  /// Value at @p distance [m], in the unit of the quantity; NaN: not known.
  double value(BlastQuantity quantity, double distance) const;

  /// Whether the tables have all quantities of a wave, reflected by a wall and
  /// not, at @p distance [m].
  bool is_tabulated(double distance) const;

  /// Nearest distance to @p distance with is_tabulated(), to 2 % [m].
  double nearest_tabulated(double distance) const;

  /// Duration of the positive phase at the nearest distance to @p distance that
  /// the tables have [s].
  double nearest_duration(double distance) const;

private:
  double nearest_tabulated(BlastQuantity quantity, double distance) const;
  const KingeryBulmash &tables(BlastQuantity quantity) const;

  KingeryBulmash of_pressure_, of_impulse_;
  ExpectedBlast source_;
};
} // namespace contrecoup

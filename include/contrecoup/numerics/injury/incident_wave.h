// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/explosives.h>
#include <contrecoup/numerics/injury/expected_blast.h>
#include <contrecoup/numerics/injury/kingery_bulmash.h>

namespace contrecoup
{
/**
 * The incident blast wave of a bare spherical charge in free air at sea level,
 * as it is known before a run: measured waves of TNT (KingeryBulmash) with the
 * charge's TNT equivalence for pressures and for impulses. Beyond the scaled
 * distances of the tables, overpressure and arrival are those of the point
 * source (ExpectedBlast), and other quantities are not known.
 *
 * Without afterburn the point source has 0.6 to 1.3 times the overpressure of
 * the measurements and an arrival up to a third too early, since it has no
 * charge whose mass is to be moved.
 */
class IncidentWave
{
public:
  /**
   * @param tnt equivalence of the explosive
   * @param mass of the charge [kg], positive
   * @param energy of the charge, of detonation and afterburn [J], positive
   * @throws InputError for other values
   */
  IncidentWave(const TntEquivalence &tnt, double mass, double energy);

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
  const KingeryBulmash &tables(BlastQuantity quantity) const;

  KingeryBulmash of_pressure_, of_impulse_;
  ExpectedBlast source_;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/**
 * The shock of a spherical point source in ideal gas of gamma = 1.4 with
 * counter-pressure, from the strong blast to the weak far field.
 *
 * Figures: S. Hancock, Blast::IPS (github.com/shancock9/blast-ips, MIT
 * licence), table S1x4: finite differences near the source, the method of
 * characteristics far away; relative error about 1e-6 by its author's
 * estimate, with the cubic interpolation that is used here too.
 */
class PointSourceSolution
{
public:
  /// The only ratio of specific heats for which there is a table [-].
  static constexpr double gamma = 1.4;

  /**
   * @param energy energy released [J], above 0
   * @param pressure ambient pressure [Pa], above 0
   * @param density ambient density [kg/m^3], above 0
   * @throws InputError for numbers outside these ranges.
   */
  PointSourceSolution(double energy, double pressure, double density);

  /// The length (E / p)^(1/3) [m] in whose multiples the table is written.
  double scaling_length() const;

  /// Smallest and largest radius of the table [m].
  double smallest_radius() const;
  double largest_radius() const;

  /// Pressure right behind the shock above the ambient one [Pa], when the
  /// shock is at @p radius [m].
  /// @throws InputError outside the table.
  double overpressure(double radius) const;

  /// The time [s] when the shock is at @p radius [m]. Its error is about
  /// 1e-7 of the time that sound would need.
  /// @throws InputError outside the table.
  double arrival_time(double radius) const;

private:
  double scaling_length_;
  double pressure_;
  double sound_speed_;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/**
 * Shock of a spherical point source in ideal gas with gamma = 1.4 and
 * counter-pressure, from strong blast to weak far field.
 *
 * Data: S. Hancock, Blast::IPS (github.com/shancock9/blast-ips, MIT licence),
 * table S1x4: finite differences near the source, method of characteristics
 * far away; relative error about 1e-6 by its author's estimate, with cubic
 * interpolation, which is used here as well.
 */
class PointSourceSolution
{
public:
  /// The tabulated ratio of specific heats [-].
  static constexpr double gamma = 1.4;

  /**
   * @param energy released energy [J], positive
   * @param pressure ambient pressure [Pa], positive
   * @param density ambient density [kg/m^3], positive
   * @throws InputError for values outside these ranges
   */
  PointSourceSolution(double energy, double pressure, double density);

  /// Length unit (E / p)^(1/3) of the table [m].
  double scaling_length() const;

  /// Smallest and largest radius of the table [m].
  double smallest_radius() const;
  double largest_radius() const;

  /// Overpressure just behind the shock at @p radius [m].
  /// @throws InputError outside the table
  double overpressure(double radius) const;

  /// Arrival time of the shock at @p radius [m]. Its error is about 1e-7 of
  /// the travel time of sound [s].
  /// @throws InputError outside the table
  double arrival_time(double radius) const;

private:
  double scaling_length_;
  double pressure_;
  double sound_speed_;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/exact/point_source.h>

namespace contrecoup
{
/**
 * A-priori estimate of arrival and strength of a spherical blast in free air:
 * the point source of equal energy (PointSourceSolution). At smaller distances
 * than tabulated, the strong shock of L. I. Sedov, t ~ r^(5/2) and
 * overpressure ~ r^-3; at larger distances an acoustic wave with overpressure
 * ~ 1 / r. The blast of a charge of finite mass is slower while the swept mass
 * of air is below the mass of the charge.
 */
class ExpectedBlast
{
public:
  /// @param energy [J], ambient @p pressure [Pa] and @p density [kg/m^3]
  /// @throws InputError unless all are positive
  ExpectedBlast(double energy, double pressure, double density);

  /// Arrival time of the front at @p distance [s].
  double arrival(double distance) const;

  /// Peak overpressure at @p distance [Pa].
  double overpressure(double distance) const;

  /// Radius of the front at @p time [m].
  double radius(double time) const;

private:
  PointSourceSolution source_;
  double sound_speed_; ///< ambient [m/s]
};

/**
 * Gas speed behind a shock of the given @p overpressure [m/s], running into
 * ideal gas at rest with gamma = 1.4, @p pressure [Pa] and @p density [kg/m^3]
 * (Rankine-Hugoniot).
 */
double speed_behind_shock(double overpressure, double pressure, double density);

/**
 * Relative error of the pressure behind such a shock in air when heat
 * capacities are taken as constant, compared at equal density and energy with
 * air whose nitrogen and oxygen vibrate as harmonic oscillators in equilibrium
 * (W. G. Vincenti and C. H. Kruger, Introduction to Physical Gas Dynamics,
 * 1965, chapter IV; characteristic temperatures 3390 K and 2270 K). Positive:
 * constant heat capacities give too high a pressure. Above some 2500 K air
 * also dissociates, and the true error is larger.
 */
double excess_pressure_of_perfect_air(double overpressure,
                                      double pressure,
                                      double density);
} // namespace contrecoup

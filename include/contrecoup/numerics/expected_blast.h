// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/point_source.h>

namespace contrecoup
{
/**
 * When and how strongly a spherical blast in free air will arrive, before
 * anything is computed: that of a point source of the same energy, see
 * PointSourceSolution. Nearer than its table the strong shock of L. I. Sedov,
 * t ~ r^(5/2) and overpressure ~ r^-3; farther away sound, and overpressure
 * ~ 1 / r. A charge of finite mass is slower while it sweeps less than its
 * own mass of air.
 */
class ExpectedBlast
{
public:
  /// @param energy [J], ambient @p pressure [Pa] and @p density [kg/m^3]
  /// @throws InputError unless all are above 0.
  ExpectedBlast(double energy, double pressure, double density);

  /// When the front is at @p distance [s].
  double arrival(double distance) const;

  /// Overpressure behind the front at @p distance [Pa].
  double overpressure(double distance) const;

  /// Distance of the front at @p time [m].
  double radius(double time) const;

private:
  PointSourceSolution source_;
  double sound_speed_; ///< ambient [m/s]
};

/**
 * Speed of the gas behind a shock of the given @p overpressure [m/s], which
 * runs into ideal gas at rest, gamma = 1.4, of @p pressure [Pa] and
 * @p density [kg/m^3] (Rankine-Hugoniot).
 */
double speed_behind_shock(double overpressure, double pressure, double density);

/**
 * By how much the pressure of air behind such a shock is too high when its
 * heat capacities are taken to be constant: relative to air whose nitrogen and
 * oxygen vibrate as harmonic oscillators in equilibrium (W. G. Vincenti and
 * C. H. Kruger, Introduction to Physical Gas Dynamics, 1965, chapter IV;
 * characteristic temperatures 3390 K and 2270 K), at equal density and energy.
 * Above some 2500 K air also dissociates, and the true difference is larger.
 */
double excess_pressure_of_perfect_air(double overpressure,
                                      double pressure,
                                      double density);
} // namespace contrecoup

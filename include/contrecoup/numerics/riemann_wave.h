// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/gas_material.h>

#include <vector>

namespace contrecoup
{
/// A uniform gas on one side of a Riemann problem, or the solution at a point.
struct RiemannState
{
  double density = 1.;  ///< [kg/m^3]
  double velocity = 0.; ///< [m/s]
  double pressure = 1.; ///< [Pa]
  double products = 0.; ///< mass fraction of explosive products [-]
};

/**
 * The nonlinear wave that runs into one uniform gas of any convex equation of
 * state: a shock (by the Hugoniot relation) where the pressure behind it is
 * higher, a centred rarefaction where it is lower.
 *
 * The isentrope is integrated once, in the logarithm of the density, down to a
 * millionth of the density ahead: dp = rho c^2 ds, du = +-c ds. Below that the
 * gas is a polytrope with the local exponent, which is exact for all equations
 * of state of this library.
 */
class RiemannWave
{
public:
  enum class Direction
  {
    left = -1,
    right = 1
  };

  /// What the gas is like behind the wave.
  struct Behind
  {
    double density;  ///< [kg/m^3]
    double velocity; ///< [m/s]
  };

  RiemannWave(const RiemannState &ahead,
              const GasMaterial &gas,
              Direction direction);

  const RiemannState &ahead() const;

  /// Pressure of the gas expanded to vacuum [Pa]: 0, or that below which a
  /// stiffened gas does not exist.
  double lowest_pressure() const;

  /// Velocity of the gas expanded to vacuum [m/s].
  double escape_velocity() const;

  /// State behind the wave for the pressure there [Pa].
  /// @throws NumericsError when the Hugoniot curve does not reach it.
  Behind behind(double pressure) const;

  /// Speed of the edge that touches the gas ahead [m/s].
  double head_speed(double pressure) const;

  /// Speed of the edge that touches the gas behind [m/s]; a shock has one.
  double tail_speed(double pressure) const;

  /// The state inside a rarefaction on the ray x/t = @p speed [m/s], between
  /// head and tail.
  RiemannState in_fan(double speed) const;

private:
  /// A point of the isentrope.
  struct Point
  {
    double log_density;
    double pressure;
    double velocity;
  };

  double sound_speed(double density, double pressure) const;
  double characteristic_speed(const Point &point) const;
  Point advance(const Point &from, double log_density) const;
  void integrate_isentrope();
  Point isentrope_at(double pressure) const;
  Point polytrope_at(double log_density) const;
  double shocked_volume(double pressure) const;

  RiemannState ahead_;
  GasMaterial gas_;
  double sign_;
  double lowest_pressure_;
  double omega_; ///< the polytrope's exponent minus one
  std::vector<Point> isentrope_;
};
} // namespace contrecoup

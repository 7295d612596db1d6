// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/gas_material.h>

#include <vector>

namespace contrecoup
{
/// Uniform state on one side of a Riemann problem, or the solution at a point.
struct RiemannState
{
  double density = 1.;  ///< [kg/m^3]
  double velocity = 0.; ///< [m/s]
  double pressure = 1.; ///< [Pa]
  double products = 0.; ///< mass fraction of explosive products [-]
};

/**
 * Nonlinear wave into a uniform gas with any convex equation of state: a shock
 * (Hugoniot relation) if the pressure behind it is higher, a centred
 * rarefaction if it is lower.
 *
 * The isentrope is integrated once, in the logarithm of density, down to a
 * millionth of the density ahead: dp = rho c^2 ds, du = +-c ds. Below, the gas
 * is a polytrope with the local exponent, which is exact for all equations of
 * state of this library. JWL below its cold curve has no real sound speed in
 * the end; there its isentrope ends.
 */
class RiemannWave
{
public:
  enum class Direction
  {
    left = -1,
    right = 1
  };

  /// State behind the wave.
  struct Behind
  {
    double density;  ///< [kg/m^3]
    double velocity; ///< [m/s]
  };

  RiemannWave(const RiemannState &ahead,
              const GasMaterial &gas,
              Direction direction);

  const RiemannState &ahead() const;

  /// Pressure of the gas expanded to vacuum [Pa]: 0, or the lowest pressure of
  /// a stiffened gas.
  double lowest_pressure() const;

  /// Velocity of the gas expanded to vacuum [m/s]; infinite where the isentrope
  /// ends before.
  double escape_velocity() const;

  /// State behind the wave for a given pressure there [Pa].
  /// @throws NumericsError when Hugoniot curve or isentrope do not reach it
  Behind behind(double pressure) const;

  /// Speed of the wave's edge next to the gas ahead [m/s].
  double head_speed(double pressure) const;

  /// Speed of the wave's edge next to the gas behind [m/s]; for a shock the
  /// same.
  double tail_speed(double pressure) const;

  /// State inside a rarefaction at x/t = @p speed [m/s], between head and
  /// tail.
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
  double omega_; ///< polytropic exponent minus one
  std::vector<Point> isentrope_;
  bool isentrope_ends_ = false; ///< where the sound speed is not real any more
};
} // namespace contrecoup

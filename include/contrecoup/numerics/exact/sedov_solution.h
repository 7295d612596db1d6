// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/exact/radial_state.h>

namespace contrecoup
{
/**
 * Point explosion in cold ideal gas of uniform density. Closed form of L. I.
 * Sedov (Similarity and Dimensional Methods in Mechanics, 1959), written as in
 * J. R. Kamm and F. X. Timmes (On efficient generation of numerically robust
 * Sedov solutions, LA-UR-07-2849, 2007), equations 33 to 47 with the density
 * exponent omega = 0. Accurate to round-off, but to six digits within 1e-6 of
 * gamma = 2, where the closed form is singular.
 */
class SedovSolution
{
public:
  /**
   * @param dimension 1 plane, 2 cylindrical, 3 spherical
   * @param gamma ratio of specific heats [-], above 1 and below 7
   * @param density ambient density [kg/m^3], positive
   * @param energy released energy [J; J/m or J/m^2 in the lower dimensions],
   * positive; in plane geometry that released to one side
   * @throws InputError for values outside these ranges
   */
  SedovSolution(unsigned int dimension,
                double gamma,
                double density,
                double energy);

  /// Dimensionless energy alpha in R = (E t^2 / (alpha rho))^(1/(2+n)).
  double alpha() const;

  /// Radius of the shock at @p time [m].
  double shock_radius(double time) const;

  /// State just behind the shock at @p time > 0.
  RadialState behind_shock(double time) const;

  /// State at @p radius [m] and @p time [s], positive. Ahead of the shock the
  /// gas is at rest with zero pressure.
  RadialState value(double radius, double time) const;

private:
  /// Position, velocity, density and pressure relative to those at the shock;
  /// lambda, f, g, h of Kamm and Timmes.
  struct Profile
  {
    double position, velocity, density, pressure;
  };

  /// Profile at c v - 1 = @p depth; see depth_at_shock_.
  Profile profile(double depth) const;

  /// Logarithm of the profile's position; finite at the centre.
  double log_position(double log_depth) const;

  /// d(log position)/d(depth) times depth.
  double log_position_slope(double depth) const;

  double compute_alpha() const;

  double dimension_, gamma_, density_, energy_;

  // Exponents a_0 to a_5 and factors a to e of Kamm and Timmes.
  double a0_, a1_, a2_, a3_, a4_, a5_, a_, b_, c_, d_, e_;

  /// The similarity variable v increases from 1 / c at the centre to 4 / ((n +
  /// 2)(gamma + 1)) at the shock. Near the centre v - 1 / c falls below
  /// round-off, so depth = c v - 1 serves as variable.
  double depth_at_shock_;

  double alpha_;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>

namespace contrecoup
{
/**
 * Isentropic vortex of C.-W. Shu (Essentially non-oscillatory and weighted
 * essentially non-oscillatory schemes for hyperbolic conservation laws, NASA
 * CR-97-206253, 1997, section 5.1), in the plane of the first two coordinates.
 * It is advected with the gas without change of shape.
 */
class VortexSolution
{
public:
  /// Density [kg/m^3], the two velocity components [m/s], pressure [Pa].
  struct State
  {
    double density;
    std::array<double, 2> velocity;
    double pressure;
  };

  double gamma = 1.4;                        ///< ratio of specific heats
  double strength = 5.;                      ///< circulation; Shu's beta
  double radius = 1.;                        ///< core radius [m]
  double period = 10.;                       ///< side of the periodic box [m]
  double density = 1.;                       ///< far from the core [kg/m^3]
  double pressure = 1.;                      ///< far from the core [Pa]
  std::array<double, 2> center = {{0, 0}};   ///< at time zero [m]
  std::array<double, 2> velocity = {{1, 1}}; ///< of the gas [m/s]

  /// State at (@p x, @p y) [m] and @p time [s], from the nearest periodic
  /// image. Half a period from the core, where images meet, the exact field
  /// has a kink of relative size exp((1 - (period/2/radius)^2) / 2): 6e-6 for
  /// the default box of ten radii.
  State value(double x, double y, double time) const;

  /// Whether the temperature of the core is positive, so that value() is
  /// physical everywhere.
  bool is_admissible() const;

private:
  /// Decrease of the relative temperature. @param distance_square squared
  /// distance in core radii
  double temperature_drop(double distance_square) const;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/point.h>

#include <vector>

namespace contrecoup
{
/// A fluid, initially at rest, in a rigid sphere with a half-sine
/// deceleration.
struct RigidSphere
{
  double radius = 0.09;        ///< R [m]
  double density = 1000.;      ///< [kg/m^3]
  double sound_speed = 1483.;  ///< c [m/s]
  double deceleration = 1000.; ///< largest, A [m/s^2]
  double duration = 1e-3;      ///< T [s]
};

/**
 * Acoustic pressure in the sphere, the problem of Anzelius and Guettinger, by
 * a series of modes that are odd along the deceleration:
 *
 *   p = rho c cos(theta) sum 2 a_n / (a_n^2 - 2) j_1(a_n r / R) / j_1(a_n)
 *         integral_0^t A(s) sin(a_n c (t - s) / R) ds,   j_1'(a_n) = 0,
 *
 * with theta measured from the initial direction of motion. For slow
 * decelerations p = rho A r cos(theta). The series converges like 1 / a_n^2 at
 * the wall.
 */
class RigidSphereSolution
{
public:
  /// @param n_modes number of terms
  explicit RigidSphereSolution(const RigidSphere &sphere,
                               const unsigned int n_modes = 200);

  /// Pressure [Pa] at @p distance [m] from the centre and @p cosine of theta,
  /// at @p time [s].
  double
  pressure(const double distance, const double cosine, const double time) const;

  /// Roots a_n [-].
  const std::vector<double> &roots() const
  {
    return roots_;
  }

private:
  double response(const double root, const double time) const;

  RigidSphere sphere_;
  std::vector<double> roots_;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/**
 * Impact of a thin elastic sphere filled with liquid on a rigid wall, as a
 * mass on a spring (Young, J. Sound Vib. 267 (2003)). The spring is a shallow
 * shell under a point load (Reissner, J. Math. Phys. 25 (1946) 80 and 279),
 * the mass is that of shell and liquid, and contact lasts for half a period.
 * If the liquid moves with the shell, its pressure is rho a z at the distance
 * z from the centre.
 *
 * That is the pressure in a rigid shell. An elastic shell stands still at the
 * contact: its acceleration is that of the sphere minus that of the dent,
 * which by Reissner is a (-4 / pi) kei(s / L) at the distance s, with L^2 = R
 * h / sqrt(12 (1 - nu^2)). The Legendre component l of the dent is
 *
 *   f_l = (2 / pi) (2 l + 1) (L / R)^2 / (1 + ((l + 1/2) L / R)^4),
 *
 * and in an incompressible liquid the pressure at the radius r, in a sphere of
 * radius R_i and at the angle theta from the dent, is
 *
 *   p = rho a (r cos(theta) - R_i sum f_l / l (r / R_i)^l P_l(cos(theta))).
 *
 * The sum omits l = 1, since a is the acceleration of the whole mass.
 */
struct FluidFilledShell
{
  double fluid_radius = 0.079;  ///< R_i [m]
  double fluid_density = 1000.; ///< rho [kg/m^3]
  double thickness = 0.007;     ///< h of the shell [m]
  double shell_density = 1800.; ///< [kg/m^3]
  double young_modulus = 6.5e9; ///< E of the shell [Pa]
  double poisson_ratio = 0.22;  ///< nu of the shell [-]
  double speed = 3.;            ///< before the impact [m/s]

  /// Radius R of the middle surface of the shell [m].
  double radius() const
  {
    return fluid_radius + 0.5 * thickness;
  }

  /// Mass of shell and liquid [kg].
  double mass() const;

  /// Spring stiffness 4 E h^2 / (R sqrt(3 (1 - nu^2))) [N/m].
  double stiffness() const;

  /// Duration of contact [s].
  double contact_time() const;

  /// Largest contact force [N].
  double peak_force() const;

  /// Largest acceleration a [m/s^2].
  double peak_acceleration() const;

  /// Legendre component f_l of the dent [-].
  double dent(const unsigned int l) const;

  /**
   * Half the difference of peak pressures at two opposite points at @p
   * distance [m] from the centre; @p cosine is that of theta at the first
   * point [Pa].
   */
  double pressure(const double distance, const double cosine) const;
};
} // namespace contrecoup

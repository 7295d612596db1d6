// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/**
 * A thin elastic sphere full of liquid that hits a rigid wall, a mass on a
 * spring (Young, J. Sound Vib. 267 (2003)): the spring is a shallow shell
 * under a point load (Reissner, J. Math. Phys. 25 (1946) 80 and 279), the mass
 * is shell and liquid. Contact lasts for half a period; the liquid goes with
 * the shell, so that its pressure is rho a z at the distance z from the middle.
 *
 * That is the pressure of a rigid wall. Where this one touches it stands still:
 * it has the acceleration of the sphere less that of its dent, which by
 * Reissner is a (-4 / pi) kei(s / L) at the distance s, with L^2 = R h /
 * sqrt(12 (1 - nu^2)). Of that, the part of the Legendre polynomial l is
 *
 *   f_l = (2 / pi) (2 l + 1) (L / R)^2 / (1 + ((l + 1/2) L / R)^4),
 *
 * and a liquid that keeps its volume has at the distance r from the middle of
 * its sphere of radius R_i, at the angle theta from the dent,
 *
 *   p = rho a (r cos(theta) - R_i sum f_l / l (r / R_i)^l P_l(cos(theta))).
 *
 * l = 1 is not in the sum, as a is that of the whole mass.
 */
struct FluidFilledShell
{
  double fluid_radius = 0.079;  ///< R_i [m]
  double fluid_density = 1000.; ///< rho [kg/m^3]
  double thickness = 0.007;     ///< h, of the shell [m]
  double shell_density = 1800.; ///< [kg/m^3]
  double young_modulus = 6.5e9; ///< E, of the shell [Pa]
  double poisson_ratio = 0.22;  ///< nu, of the shell [-]
  double speed = 3.;            ///< before the impact [m/s]

  /// R, of the middle of the shell [m].
  double radius() const
  {
    return fluid_radius + 0.5 * thickness;
  }

  /// Of shell and liquid [kg].
  double mass() const;

  /// 4 E h^2 / (R sqrt(3 (1 - nu^2))) [N/m].
  double stiffness() const;

  /// How long shell and wall touch [s].
  double contact_time() const;

  /// The largest force of the wall [N].
  double peak_force() const;

  /// The largest acceleration a [m/s^2].
  double peak_acceleration() const;

  /// The part f_l of the dent [-].
  double dent(const unsigned int l) const;

  /**
   * Half the difference of the largest pressure at @p distance [m] from the
   * middle, in a direction with this @p cosine of theta, and of that opposite
   * [Pa].
   */
  double pressure(const double distance, const double cosine) const;
};
} // namespace contrecoup

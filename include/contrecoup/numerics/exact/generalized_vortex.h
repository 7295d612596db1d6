// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/element/neo_hookean.h>

#include <deal.II/base/point.h>

#include <array>

namespace contrecoup
{
/**
 * Generalized vortex (Kamojjala, Brannon, Sadeghirad and Guilkey, Eng. Comput.
 * 31 (2015) 201): a ring of neo-Hookean material in plane strain, whose
 * circles rotate about the common centre, the middle one most and both edges
 * not at all, by the angle
 *
 *   a(R, t) = A sin(pi t / T) h(R),   h = (1 - (2 (R - M) / W)^2)^2,
 *
 * with the mean radius M and the width W of the ring. The motion is isochoric.
 * The edges are free of traction, since a and da/dR vanish there. The body
 * force balances acceleration and stress, which is that of simple shear by k =
 * R da/dR.
 */
struct GeneralizedVortex
{
  NeoHookean solid;
  double inner_radius = 0.75; ///< [m]
  double outer_radius = 1.25; ///< [m]
  double angle = 1.;          ///< largest angle A [rad]
  double half_period = 1.;    ///< T, half a period [s]

  /// Present position of the material point @p start [m].
  dealii::Point<2> position(const dealii::Point<2> &start,
                            const double time) const;

  /// Velocity of the material point @p start [m/s].
  dealii::Tensor<1, 2> velocity(const dealii::Point<2> &start,
                                const double time) const;

  /// Deformation gradient.
  dealii::Tensor<2, 2> gradient(const dealii::Point<2> &start,
                                const double time) const;

  /// Body force per mass on the material point @p start [m/s^2].
  dealii::Tensor<1, 2> body_force(const dealii::Point<2> &start,
                                  const double time) const;

private:
  /// h and its first two derivatives.
  std::array<double, 3> profile(const double radius) const;
};
} // namespace contrecoup

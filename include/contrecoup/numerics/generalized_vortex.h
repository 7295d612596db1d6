// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/neo_hookean.h>

#include <deal.II/base/point.h>

namespace contrecoup
{
/**
 * A ring of neo-Hookean matter whose circles turn about their common centre,
 * those in the middle the most and both edges not at all (Kamojjala, Brannon,
 * Sadeghirad and Guilkey, Eng. Comput. 31 (2015) 201, "generalized vortex"), in
 * plane strain: by the angle
 *
 *   a(R, t) = A sin(pi t / T) h(R),   h = (1 - (2 (R - M) / W)^2)^2,
 *
 * M and W being the middle and the width of the ring. It keeps its volume and
 * needs no forces at its edges, where a and da/dR vanish, but a body force that
 * makes up for what acceleration and stress do not balance; that was derived
 * from the stress of a simple shear by k = R da/dR.
 */
struct GeneralizedVortex
{
  NeoHookean solid;
  double inner_radius = 0.75; ///< [m]
  double outer_radius = 1.25; ///< [m]
  double angle = 1.;          ///< A, the largest [rad]
  double half_period = 1.;    ///< T, after which all is back [s]

  /// Where matter that began at @p start is [m].
  dealii::Point<2> position(const dealii::Point<2> &start,
                            const double time) const;

  /// [m/s]
  dealii::Tensor<1, 2> velocity(const dealii::Point<2> &start,
                                const double time) const;

  /// Deformation gradient.
  dealii::Tensor<2, 2> gradient(const dealii::Point<2> &start,
                                const double time) const;

  /// The body force by mass on matter that began at @p start [m/s^2].
  dealii::Tensor<1, 2> body_force(const dealii::Point<2> &start,
                                  const double time) const;

private:
  /// h and its first two derivatives.
  std::array<double, 3> profile(const double radius) const;
};
} // namespace contrecoup

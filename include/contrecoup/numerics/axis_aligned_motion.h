// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/neo_hookean.h>

#include <deal.II/base/point.h>

namespace contrecoup
{
/**
 * A unit square of neo-Hookean matter whose lines stay along the axes, in plane
 * strain (Sadeghirad, Brannon and Burghardt, Int. J. Numer. Meth. Engng 86
 * (2011) 1435; Steffen, Wallstedt, Guilkey, Kirby and Berzins, CMES 31 (2008)
 * 107, in one dimension):
 *
 *   u = A sin(pi X) sin(c pi t),   v = A sin(pi Y) sin(c pi t + pi),
 *
 * which makes edges and the middle of the square rest in the direction of their
 * normals. The body force is what acceleration and stress do not balance.
 */
struct AxisAlignedMotion
{
  NeoHookean solid{1., 3846.1538, 8333.3333, NeoHookeanForm::split};
  double amplitude = 0.05; ///< A [m]
  double speed = 100.;     ///< c, in lengths of a square of 1 m [m/s]

  /// Of matter that began at @p start [m].
  dealii::Point<2> position(const dealii::Point<2> &start,
                            const double time) const;

  /// [m/s]
  dealii::Tensor<1, 2> velocity(const dealii::Point<2> &start,
                                const double time) const;

  /// What the axes are stretched by: the deformation gradient's diagonal.
  dealii::Tensor<1, 2> stretches(const dealii::Point<2> &start,
                                 const double time) const;

  /// The body force by mass on matter that began at @p start [m/s^2].
  dealii::Tensor<1, 2> body_force(const dealii::Point<2> &start,
                                  const double time) const;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/element/neo_hookean.h>

#include <deal.II/base/point.h>

namespace contrecoup
{
/**
 * A unit square of neo-Hookean material whose material lines stay parallel to
 * the axes, in plane strain (Sadeghirad, Brannon and Burghardt, Int. J. Numer.
 * Meth. Engng 86 (2011) 1435; Steffen, Wallstedt, Guilkey, Kirby and Berzins,
 * CMES 31 (2008) 107, in one dimension):
 *
 *   u = A sin(pi X) sin(c pi t),   v = A sin(pi Y) sin(c pi t + pi).
 *
 * The normal displacement vanishes on the edges and at the centre lines. The
 * body force is the residual of acceleration and stress divergence.
 */
struct AxisAlignedMotion
{
  NeoHookean solid{1., 3846.1538, 8333.3333, NeoHookeanForm::split};
  double amplitude = 0.05; ///< A [m]
  double speed = 100.;     ///< c for a square of 1 m [m/s]

  /// Present position of the material point @p start [m].
  dealii::Point<2> position(const dealii::Point<2> &start,
                            const double time) const;

  /// Velocity of the material point @p start [m/s].
  dealii::Tensor<1, 2> velocity(const dealii::Point<2> &start,
                                const double time) const;

  /// Stretches along the axes: diagonal of the deformation gradient.
  dealii::Tensor<1, 2> stretches(const dealii::Point<2> &start,
                                 const double time) const;

  /// Body force per mass on the material point @p start [m/s^2].
  dealii::Tensor<1, 2> body_force(const dealii::Point<2> &start,
                                  const double time) const;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/axis_aligned_motion.h>

#include <deal.II/base/numbers.h>

namespace contrecoup
{
namespace
{
  using dealii::Point;
  using dealii::Tensor;
  using dealii::numbers::PI;

  /// Derivative of the Piola stress along an axis with respect to its stretch
  /// @p a. @param b stretch of the other in-plane axis
  double stiffness(const NeoHookean &solid, const double a, const double b)
  {
    const double j = a * b;
    if (solid.form == NeoHookeanForm::split)
    {
      const double squares = a * a + b * b + 1.;
      return solid.shear / std::cbrt(j * j) *
               (5. * squares / (9. * a * a) - 1. / 3.) +
             solid.bulk * b * b;
    }
    return solid.shear * (1. + 1. / (a * a)) +
           (solid.bulk - 2. / 3. * solid.shear) * (1. - std::log(j)) / (a * a);
  }
} // namespace


Point<2> AxisAlignedMotion::position(const Point<2> &start,
                                     const double time) const
{
  const double part = amplitude * std::sin(speed * PI * time);
  return {start[0] + part * std::sin(PI * start[0]),
          start[1] - part * std::sin(PI * start[1])};
}


Tensor<1, 2> AxisAlignedMotion::velocity(const Point<2> &start,
                                         const double time) const
{
  const double part = amplitude * speed * PI * std::cos(speed * PI * time);
  Tensor<1, 2> result;
  result[0] = part * std::sin(PI * start[0]);
  result[1] = -part * std::sin(PI * start[1]);
  return result;
}


Tensor<1, 2> AxisAlignedMotion::stretches(const Point<2> &start,
                                          const double time) const
{
  const double part = amplitude * PI * std::sin(speed * PI * time);
  Tensor<1, 2> result;
  result[0] = 1. + part * std::cos(PI * start[0]);
  result[1] = 1. - part * std::cos(PI * start[1]);
  return result;
}


Tensor<1, 2> AxisAlignedMotion::body_force(const Point<2> &start,
                                           const double time) const
{
  // The acceleration of u is -(c pi)^2 u; the derivative of the stretch along
  // its axis is -pi^2 u.
  const Tensor<1, 2> stretch = stretches(start, time);
  const Tensor<1, 2> u = position(start, time) - start;
  Tensor<1, 2> result;
  for (unsigned int d = 0; d < 2; ++d)
    result[d] = PI * PI * u[d] *
                (stiffness(solid, stretch[d], stretch[1 - d]) / solid.density -
                 speed * speed);
  return result;
}
} // namespace contrecoup

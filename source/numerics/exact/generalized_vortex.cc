// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/generalized_vortex.h>

#include <deal.II/base/numbers.h>

namespace contrecoup
{
namespace
{
  using dealii::Point;
  using dealii::Tensor;
  using dealii::numbers::PI;

  /// Rotates a vector by 90 degrees counterclockwise.
  Tensor<1, 2> turned(const Tensor<1, 2> &v)
  {
    Tensor<1, 2> result;
    result[0] = -v[1];
    result[1] = v[0];
    return result;
  }
} // namespace


std::array<double, 3> GeneralizedVortex::profile(const double radius) const
{
  if (radius <= inner_radius || radius >= outer_radius)
    return {{0., 0., 0.}};
  const double scale = 2. / (outer_radius - inner_radius);
  const double s = scale * (radius - 0.5 * (inner_radius + outer_radius));
  const double rest = 1. - s * s;
  return {
    {rest * rest, -4. * scale * s * rest, scale * scale * (12. * s * s - 4.)}};
}


Point<2> GeneralizedVortex::position(const Point<2> &start,
                                     const double time) const
{
  const double a =
    angle * std::sin(PI * time / half_period) * profile(start.norm())[0];
  return Point<2>(std::cos(a) * start + std::sin(a) * turned(start));
}


Tensor<1, 2> GeneralizedVortex::velocity(const Point<2> &start,
                                         const double time) const
{
  const double rate = angle * PI / half_period *
                      std::cos(PI * time / half_period) *
                      profile(start.norm())[0];
  return rate * turned(position(start, time));
}


Tensor<2, 2> GeneralizedVortex::gradient(const Point<2> &start,
                                         const double time) const
{
  const double radius = start.norm();
  const auto h = profile(radius);
  const double part = angle * std::sin(PI * time / half_period);
  const double a = part * h[0];
  Tensor<2, 2> result;
  result[0][0] = result[1][1] = std::cos(a);
  result[0][1] = -std::sin(a);
  result[1][0] = std::sin(a);
  if (radius > 0.)
    result += outer_product(turned(position(start, time)),
                            Tensor<1, 2>(part * h[1] / radius * start));
  return result;
}


Tensor<1, 2> GeneralizedVortex::body_force(const Point<2> &start,
                                           const double time) const
{
  const double radius = start.norm();
  if (!(radius > 0.))
    return {};
  const auto h = profile(radius);
  const double w = PI / half_period;
  const double part = angle * std::sin(w * time);
  const double rate = angle * w * std::cos(w * time) * h[0];
  const double k = radius * part * h[1];
  const double k_slope = part * (h[1] + radius * h[2]);
  // Divergence of stress: radial s_rr' + (s_rr - s_tt) / r, tangential s_rt' +
  // 2 s_rt / r.
  const double g = solid.shear / solid.density;
  double along = -g * k * k / radius;
  if (solid.form == NeoHookeanForm::split)
    along -= g * 2. / 3. * k * k_slope;
  const double around = g * (k_slope + 2. * k / radius);
  const Tensor<1, 2> outwards = position(start, time) / radius;
  return (-radius * rate * rate - along) * outwards +
         (-radius * w * w * part * h[0] - around) * turned(outwards);
}
} // namespace contrecoup

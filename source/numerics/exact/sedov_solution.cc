// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/exact/sedov_solution.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
namespace
{
  /// Keeps off gamma = 2, a pole of the exponents a_4 and a_5 that cancels in
  /// the density.
  double keep_off_pole(const double gamma)
  {
    constexpr double distance = 1e-6;
    return (std::abs(gamma - 2.) < distance) ? 2. + distance : gamma;
  }
} // namespace


SedovSolution::SedovSolution(const unsigned int dimension,
                             const double gamma,
                             const double density,
                             const double energy)
  : dimension_(dimension)
  , gamma_(keep_off_pole(gamma))
  , density_(density)
  , energy_(energy)
{
  if (dimension < 1 || dimension > 3 || !(gamma > 1.) || !(gamma < 7.) ||
      !(density > 0.) || !(energy > 0.))
    throw InputError("Sedov's solution needs a dimension of 1 to 3, gamma "
                     "between 1 and 7 (an ideal gas), density and energy "
                     "above 0");

  const double n = dimension_, g = gamma_;

  a0_ = 2. / (n + 2.);
  a2_ = -(g - 1.) / (2. * (g - 1.) + n);
  a1_ = (n + 2.) * g / (2. + n * (g - 1.)) *
        (2. * n * (2. - g) / (g * (n + 2.) * (n + 2.)) - a2_);
  a3_ = n / (2. * (g - 1.) + n);
  a4_ = (n + 2.) / (2. - g) * a1_;
  a5_ = -2. / (2. - g);

  a_ = 0.25 * (n + 2.) * (g + 1.);
  b_ = (g + 1.) / (g - 1.);
  c_ = 0.5 * (n + 2.) * g;
  d_ = (n + 2.) * (g + 1.) / ((n + 2.) * (g + 1.) - 2. * (2. + n * (g - 1.)));
  e_ = 0.5 * (2. + n * (g - 1.));

  depth_at_shock_ = (g - 1.) / (g + 1.);
  alpha_ = compute_alpha();
}


double SedovSolution::alpha() const
{
  return alpha_;
}


double SedovSolution::shock_radius(const double time) const
{
  return std::pow(energy_ * time * time / (alpha_ * density_),
                  1. / (dimension_ + 2.));
}


RadialState SedovSolution::behind_shock(const double time) const
{
  const double shock_speed = 2. / (dimension_ + 2.) * shock_radius(time) / time;
  return {density_ * (gamma_ + 1.) / (gamma_ - 1.),
          2. * shock_speed / (gamma_ + 1.),
          2. * density_ * shock_speed * shock_speed / (gamma_ + 1.)};
}


RadialState SedovSolution::value(const double radius, const double time) const
{
  const double position = radius / shock_radius(time);
  if (position > 1.)
    return {density_, 0., 0.};

  // At smaller positions the profile equals that of the centre to round-off.
  const double log_target = std::log(std::max(position, 1e-12));
  const double highest = std::log(depth_at_shock_);
  double lowest = highest - 1.;
  while (log_position(lowest) > log_target)
    lowest = highest - 2. * (highest - lowest);

  double log_depth = highest;
  if (log_position(highest) > log_target)
  {
    std::uintmax_t iterations = 200;
    const auto bracket = boost::math::tools::toms748_solve(
      [&](const double x) { return log_position(x) - log_target; },
      lowest,
      highest,
      boost::math::tools::eps_tolerance<double>(50),
      iterations);
    log_depth = 0.5 * (bracket.first + bracket.second);
  }

  const Profile fraction = profile(std::exp(log_depth));
  const RadialState shock = behind_shock(time);
  return {shock.density * fraction.density,
          (radius > 0.) ? shock.velocity * fraction.velocity : 0.,
          shock.pressure * fraction.pressure};
}


SedovSolution::Profile SedovSolution::profile(const double depth) const
{
  const double v = (1. + depth) / c_;
  const double x1 = a_ * v;
  const double x2 = b_ * depth;
  const double x3 = d_ * (1. - e_ * v);
  const double x4 = b_ * (gamma_ - 1. - depth) / gamma_;

  Profile result;
  result.position =
    std::pow(x1, -a0_) * std::pow(x2, -a2_) * std::pow(x3, -a1_);
  result.velocity = x1 * result.position;

  // The pole of a_4 and a_5 cancels in the sum of logarithms.
  const double common = a4_ * std::log(x3) + a5_ * std::log(x4);
  result.density = std::exp(a3_ * std::log(x2) + common);
  result.pressure = std::exp(a0_ * dimension_ * std::log(x1) -
                             2. * a1_ * std::log(x3) + std::log(x4) + common);
  return result;
}


double SedovSolution::log_position(const double log_depth) const
{
  const double v = (1. + std::exp(log_depth)) / c_;
  return -a0_ * std::log(a_ * v) - a2_ * (std::log(b_) + log_depth) -
         a1_ * std::log(d_ * (1. - e_ * v));
}


double SedovSolution::log_position_slope(const double depth) const
{
  const double v = (1. + depth) / c_;
  return -a0_ * depth / (1. + depth) - a2_ +
         a1_ * e_ * depth / (c_ * (1. - e_ * v));
}


double SedovSolution::compute_alpha() const
{
  using boost::math::double_constants::pi;
  const double sphere =
    (dimension_ == 1.) ? 1. : (dimension_ == 2. ? 2. * pi : 4. * pi);

  // Energy of the profile, integrated over d(log position). With depth =
  // depth_at_shock s^m the integrand is smooth in s at the centre.
  const double m = -4. / (dimension_ * a2_);
  const auto integrand = [&](const double s) {
    const double depth = depth_at_shock_ * std::pow(s, m);
    const Profile at = profile(depth);
    return (at.density * at.velocity * at.velocity + at.pressure) *
           std::pow(at.position, dimension_) * log_position_slope(depth) * m /
           s;
  };

  double integral = 0.;
  constexpr unsigned int panels = 64;
  for (unsigned int i = 0; i < panels; ++i)
    integral += boost::math::quadrature::gauss<double, 15>::integrate(
      integrand, double(i) / panels, double(i + 1) / panels);

  const double speed = 2. / (dimension_ + 2.);
  return sphere * speed * speed * 2. / (gamma_ * gamma_ - 1.) * integral;
}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/materials/mie_grueneisen.h>
#include <contrecoup/numerics/exact/detonation_solution.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace contrecoup
{
namespace
{
  /// Isentrope of the products through one state: the pressure above the cold
  /// curve is proportional to rho^(1 + omega).
  class Isentrope
  {
  public:
    Isentrope(const JwlParameters &jwl,
              const double density,
              const double pressure)
      : products_(MieGrueneisen::jwl(jwl))
      , exponent_(1. + jwl.omega)
      , factor_((pressure - cold_pressure(density)) /
                std::pow(density, exponent_))
    {}

    double pressure(const double density) const
    {
      return cold_pressure(density) + factor_ * std::pow(density, exponent_);
    }

    double sound_speed_squared(const double density) const
    {
      return products_.sound_speed_squared(density, pressure(density), 1.);
    }

  private:
    double cold_pressure(const double density) const
    {
      return products_.pressure(
        density, products_.cold_energy_density(density, 1.), 1.);
    }

    MieGrueneisen products_;
    double exponent_;
    double factor_;
  };

  using Values = std::array<double, 2>; ///< ln xi and ln rho

  Values sum(const Values &a, const double factor, const Values &b)
  {
    return {{a[0] + factor * b[0], a[1] + factor * b[1]}};
  }

  /// Derivatives with respect to ln u.
  Values slope(const Isentrope &isentrope,
               const unsigned int exponent,
               const double velocity,
               const Values &at)
  {
    const double square = isentrope.sound_speed_squared(std::exp(at[1]));
    if (exponent == 0)
    {
      const double c = std::sqrt(square);
      return {{0., velocity / c}};
    }
    const double relative = std::exp(at[0]) - velocity;
    return {{(relative * relative / square - 1.) / exponent,
             velocity * relative / square}};
  }
} // namespace


DetonationSolution::DetonationSolution(const unsigned int dimension,
                                       const JwlParameters &jwl)
  : front_(chapman_jouguet(jwl))
{
  if (dimension < 1 || dimension > 3)
    throw InputError("A detonation spreads in 1 to 3 dimensions, not in " +
                     std::to_string(dimension));
  const unsigned int exponent = dimension - 1;
  const Isentrope isentrope(jwl, front_.density, front_.pressure);

  // Integrate in ln u down to a negligible velocity.
  const unsigned int n_steps = 6000;
  const double smallest = 1e-12;
  const double step = std::log(smallest) / n_steps;
  Values at = {{std::log(front_.detonation_speed), std::log(front_.density)}};
  for (unsigned int i = 0; i <= n_steps; ++i)
  {
    const double velocity = front_.velocity * std::exp(i * step);
    const double density = std::exp(at[1]);
    const double speed =
      exponent > 0
        ? std::exp(at[0])
        : velocity + std::sqrt(isentrope.sound_speed_squared(density));
    points_.push_back(
      {speed, {density, velocity, isentrope.pressure(density)}});
    const double middle = velocity * std::exp(0.5 * step);
    const double next = velocity * std::exp(step);
    const Values a = slope(isentrope, exponent, velocity, at);
    const Values b = slope(isentrope, exponent, middle, sum(at, 0.5 * step, a));
    const Values c = slope(isentrope, exponent, middle, sum(at, 0.5 * step, b));
    const Values d = slope(isentrope, exponent, next, sum(at, step, c));
    at = sum(sum(at, step / 6., sum(a, 2., b)), step / 6., sum(d, 2., c));
  }
  std::reverse(points_.begin(), points_.end());
  points_.front().state.velocity = 0.;
}


RadialState DetonationSolution::value(const double speed) const
{
  if (speed <= points_.front().speed)
    return points_.front().state;
  const auto above = std::upper_bound(
    points_.begin(),
    points_.end(),
    speed,
    [](const double x, const Point &point) { return x < point.speed; });
  if (above == points_.end())
    return points_.back().state;
  const Point &b = *above;
  const Point &a = *std::prev(above);
  const double weight = (speed - a.speed) / (b.speed - a.speed);
  const auto mix = [weight](const double x, const double y) {
    return x + weight * (y - x);
  };
  return {mix(a.state.density, b.state.density),
          mix(a.state.velocity, b.state.velocity),
          mix(a.state.pressure, b.state.pressure)};
}
} // namespace contrecoup

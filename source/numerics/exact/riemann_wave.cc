// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/exact/riemann_wave.h>

#include <boost/math/tools/roots.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace contrecoup
{
namespace
{
  constexpr double step_size = 0.01;           // in log(density)
  constexpr double depth = 13.815510557964274; // log(1e6)

  /// Root of @p f in [@p a, @p b], to round-off.
  template <typename Function>
  double root(const Function &f, const double a, const double b)
  {
    const double f_a = f(a), f_b = f(b);
    if (f_a == 0.)
      return a;
    if (f_b == 0.)
      return b;
    std::uintmax_t iterations = 200;
    const auto bracket = boost::math::tools::toms748_solve(
      f,
      a,
      b,
      f_a,
      f_b,
      boost::math::tools::eps_tolerance<double>(52),
      iterations);
    return 0.5 * (bracket.first + bracket.second);
  }
} // namespace


RiemannWave::RiemannWave(const RiemannState &ahead,
                         const GasMaterial &gas,
                         const Direction direction)
  : ahead_(ahead)
  , gas_(gas)
  , sign_(direction == Direction::left ? -1. : 1.)
{
  const double dilute = 1e-12 * ahead.density;
  lowest_pressure_ = gas.pressure(
    dilute, gas.least_energy_density(dilute, ahead.products), ahead.products);
  integrate_isentrope();
}


const RiemannState &RiemannWave::ahead() const
{
  return ahead_;
}


double RiemannWave::lowest_pressure() const
{
  return lowest_pressure_;
}


double RiemannWave::sound_speed(const double density,
                                const double pressure) const
{
  return std::sqrt(
    std::max(gas_.sound_speed_squared(density, pressure, ahead_.products), 0.));
}


double RiemannWave::characteristic_speed(const Point &point) const
{
  return point.velocity +
         sign_ * sound_speed(std::exp(point.log_density), point.pressure);
}


RiemannWave::Point RiemannWave::advance(const Point &from,
                                        const double log_density) const
{
  using State = std::array<double, 2>;
  boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper;
  State state{{from.pressure, from.velocity}};
  stepper.do_step(
    [&](const State &at, State &slope, const double s) {
      const double density = std::exp(s);
      const double c = sound_speed(density, at[0]);
      slope[0] = density * c * c;
      slope[1] = sign_ * c;
    },
    state,
    from.log_density,
    log_density - from.log_density);
  return {log_density, state[0], state[1]};
}


void RiemannWave::integrate_isentrope()
{
  const double start = std::log(ahead_.density);
  isentrope_.push_back({start, ahead_.pressure, ahead_.velocity});
  const unsigned int n_steps = std::lround(depth / step_size);
  for (unsigned int i = 1; i <= n_steps && !isentrope_ends_; ++i)
  {
    const Point next = advance(isentrope_.back(), start - i * step_size);
    isentrope_ends_ =
      !(sound_speed(std::exp(next.log_density), next.pressure) > 0.);
    if (!isentrope_ends_)
      isentrope_.push_back(next);
  }

  const Point &last = isentrope_.back();
  const double density = std::exp(last.log_density);
  const double c = sound_speed(density, last.pressure);
  omega_ = c * c * density / (last.pressure - lowest_pressure_) - 1.;
}


RiemannWave::Point RiemannWave::polytrope_at(const double log_density) const
{
  const Point &last = isentrope_.back();
  const double c_last = sound_speed(std::exp(last.log_density), last.pressure);
  const double decrease = log_density - last.log_density;
  return {log_density,
          lowest_pressure_ + (last.pressure - lowest_pressure_) *
                               std::exp((1. + omega_) * decrease),
          last.velocity +
            sign_ * 2. / omega_ * c_last * std::expm1(0.5 * omega_ * decrease)};
}


double RiemannWave::escape_velocity() const
{
  if (isentrope_ends_)
    return -sign_ * std::numeric_limits<double>::infinity();
  const Point &last = isentrope_.back();
  return last.velocity -
         sign_ * 2. / omega_ *
           sound_speed(std::exp(last.log_density), last.pressure);
}


RiemannWave::Point RiemannWave::isentrope_at(const double pressure) const
{
  const Point &last = isentrope_.back();
  if (pressure <= last.pressure && isentrope_ends_)
    throw NumericsError("The gas of density " + brief(ahead_.density) +
                        " kg/m^3 has no real sound speed when it expands to a "
                        "pressure of " +
                        brief(pressure) + " Pa");
  if (pressure <= last.pressure)
    return polytrope_at(last.log_density +
                        std::log((pressure - lowest_pressure_) /
                                 (last.pressure - lowest_pressure_)) /
                          (1. + omega_));
  const auto below = std::lower_bound(
    isentrope_.begin() + 1,
    isentrope_.end(),
    pressure,
    [](const Point &point, const double p) { return point.pressure > p; });
  const Point &above = *(below - 1);
  const double log_density =
    root([&](const double s) { return advance(above, s).pressure - pressure; },
         below->log_density,
         above.log_density);
  return advance(above, log_density);
}


double RiemannWave::shocked_volume(const double pressure) const
{
  const double volume = 1. / ahead_.density;
  const double energy = gas_.internal_energy_density(
                          ahead_.density, ahead_.pressure, ahead_.products) *
                        volume;
  const auto excess = [&](const double v) {
    return gas_.internal_energy_density(1. / v, pressure, ahead_.products) * v -
           energy - 0.5 * (pressure + ahead_.pressure) * (volume - v);
  };

  // Searching in compression, the first root is on the Hugoniot curve.
  double larger = volume;
  if (excess(larger) <= 0.) // jump below round-off
    return larger;
  for (unsigned int i = 0; i < 1000; ++i)
  {
    const double smaller = 0.97 * larger;
    if (excess(smaller) <= 0.)
      return root(excess, smaller, larger);
    larger = smaller;
  }
  throw NumericsError("No shock takes the gas of density " +
                      brief(ahead_.density) + " kg/m^3 to a pressure of " +
                      brief(pressure) + " Pa");
}


RiemannWave::Behind RiemannWave::behind(const double pressure) const
{
  if (pressure == ahead_.pressure)
    return {ahead_.density, ahead_.velocity};
  if (pressure < ahead_.pressure)
  {
    const Point point = isentrope_at(pressure);
    return {std::exp(point.log_density), point.velocity};
  }
  const double volume = shocked_volume(pressure);
  const double jump = std::sqrt((pressure - ahead_.pressure) *
                                std::max(1. / ahead_.density - volume, 0.));
  return {1. / volume, ahead_.velocity + sign_ * jump};
}


double RiemannWave::head_speed(const double pressure) const
{
  if (pressure <= ahead_.pressure)
    return characteristic_speed(isentrope_.front());
  // Mass flux through the shock over the density ahead.
  const double volume = shocked_volume(pressure);
  return ahead_.velocity + sign_ / ahead_.density *
                             std::sqrt((pressure - ahead_.pressure) /
                                       (1. / ahead_.density - volume));
}


double RiemannWave::tail_speed(const double pressure) const
{
  if (pressure >= ahead_.pressure)
    return head_speed(pressure);
  return characteristic_speed(isentrope_at(pressure));
}


RiemannState RiemannWave::in_fan(const double speed) const
{
  const auto excess = [&](const Point &point) {
    return sign_ * (characteristic_speed(point) - speed);
  };
  Point point = isentrope_.back();
  if (excess(point) >= 0.)
  {
    const double c_last =
      sound_speed(std::exp(point.log_density), point.pressure);
    const double c = c_last - excess(point) / (1. + 2. / omega_);
    point = polytrope_at(point.log_density +
                         2. / omega_ * std::log(std::max(c, 0.) / c_last));
  }
  else
  {
    const auto behind = std::partition_point(
      isentrope_.begin() + 1,
      isentrope_.end() - 1,
      [&](const Point &candidate) { return excess(candidate) > 0.; });
    const Point &before = *(behind - 1);
    const double log_density =
      root([&](const double s) { return excess(advance(before, s)); },
           behind->log_density,
           before.log_density);
    point = advance(before, log_density);
  }
  return {std::exp(point.log_density),
          point.velocity,
          point.pressure,
          ahead_.products};
}
} // namespace contrecoup

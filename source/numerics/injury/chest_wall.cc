// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/injury/chest_wall.h>

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace contrecoup
{
namespace
{
  const double mass = 2.03;           // kg
  const double damping = 696.;        // kg/s
  const double stiffness = 989.;      // N/m
  const double area = 0.082;          // m^2
  const double lung_volume = 1.82e-3; // m^3
  const double gamma = 1.2;

  using State = std::array<double, 2>; // displacement, velocity

  double lung_pressure(const double displacement, const double ambient)
  {
    // A trial step may overshoot.
    const double least = 1e-3 * lung_volume;
    const double left = std::max(lung_volume - area * displacement, least);
    return ambient * std::pow(lung_volume / left, gamma);
  }
} // namespace


ChestWallResponse chest_wall_response(const std::vector<double> &times,
                                      const std::vector<double> &overpressures,
                                      const double ambient_pressure)
{
  namespace odeint = boost::numeric::odeint;
  if (times.size() != overpressures.size())
    throw InputError("chest wall: " + std::to_string(times.size()) +
                     " times, but " + std::to_string(overpressures.size()) +
                     " overpressures");
  ChestWallResponse result;
  State state = {{0., 0.}};
  const auto stepper =
    odeint::make_controlled(1e-10, 1e-8, odeint::runge_kutta_dopri5<State>());
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
  {
    const double duration = times[i + 1] - times[i];
    if (!(duration > 0.))
      throw InputError("chest wall: the times of a load must increase");
    const double slope = (overpressures[i + 1] - overpressures[i]) / duration;
    const auto rates = [&](const State &x, State &rate, const double t) {
      const double load = overpressures[i] + slope * t + ambient_pressure -
                          lung_pressure(x[0], ambient_pressure);
      rate[0] = x[1];
      rate[1] = (area * load - damping * x[1] - stiffness * x[0]) / mass;
    };
    const auto observe = [&](const State &x, double) {
      result.displacement = std::max(result.displacement, x[0]);
      result.velocity = std::max(result.velocity, x[1]);
    };
    odeint::integrate_adaptive(
      stepper, rates, state, 0., duration, std::min(duration, 1e-5), observe);
  }
  result.lung_pressure =
    lung_pressure(result.displacement, ambient_pressure) - ambient_pressure;
  return result;
}


double thorax_injury_index(const double chest_wall_velocity)
{
  return std::pow(0.124 + 0.117 * chest_wall_velocity, 2.63);
}
} // namespace contrecoup

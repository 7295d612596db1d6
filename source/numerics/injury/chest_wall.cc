// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/injury/chest_wall.h>

#include <algorithm>
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
  const double polytropic_exponent = 1.2;

  /// Least volume of air that the lung is compressed to.
  const double least_volume = 1e-3 * lung_volume;

  /// Bounds of a step [s].
  const double longest = 1e-5, shortest = 1e-8;

  struct Rate
  {
    double displacement;
    double velocity;
  };

  double lung_pressure(const double displacement, const double ambient)
  {
    const double left =
      std::max(lung_volume - area * displacement, least_volume);
    return ambient * std::pow(lung_volume / left, polytropic_exponent);
  }

  Rate rate_of(const double displacement,
               const double velocity,
               const double overpressure,
               const double ambient)
  {
    const double load =
      overpressure + ambient - lung_pressure(displacement, ambient);
    return {velocity,
            (area * load - damping * velocity - stiffness * displacement) /
              mass};
  }

  /// A step that resolves the oscillation on the air that is left in the lung,
  /// and in which the wall displaces a small part of it [s].
  double allowed_step(const ChestWall &wall, const double ambient)
  {
    const double left = lung_volume - area * wall.displacement;
    if (left <= least_volume)
      return longest;
    const double of_air = polytropic_exponent * area * area *
                          lung_pressure(wall.displacement, ambient) / left;
    const double frequency = std::sqrt((stiffness + of_air) / mass);
    const double flow = area * std::abs(wall.velocity);
    const double step =
      std::min(0.2 / frequency, flow > 0. ? 0.1 * left / flow : longest);
    return std::clamp(step, shortest, longest);
  }

  void take_step(ChestWall &wall,
                 const double begin,
                 const double middle,
                 const double end,
                 const double step,
                 const double ambient)
  {
    const double x = wall.displacement, v = wall.velocity, half = 0.5 * step;
    const Rate a = rate_of(x, v, begin, ambient);
    const Rate b = rate_of(
      x + half * a.displacement, v + half * a.velocity, middle, ambient);
    const Rate c = rate_of(
      x + half * b.displacement, v + half * b.velocity, middle, ambient);
    const Rate d =
      rate_of(x + step * c.displacement, v + step * c.velocity, end, ambient);
    wall.displacement += step / 6. *
                         (a.displacement + 2. * b.displacement +
                          2. * c.displacement + d.displacement);
    wall.velocity +=
      step / 6. * (a.velocity + 2. * b.velocity + 2. * c.velocity + d.velocity);
    wall.largest_displacement =
      std::max(wall.largest_displacement, wall.displacement);
    wall.largest_velocity = std::max(wall.largest_velocity, wall.velocity);
  }
} // namespace


void ChestWall::advance(const double first,
                        const double last,
                        const double duration,
                        const double ambient_pressure)
{
  const double slope = duration > 0. ? (last - first) / duration : 0.;
  double time = 0.;
  while (time < duration)
  {
    // Equal steps over what is left, so that no step is a tiny rest.
    const double left = duration - time;
    const double n_steps =
      std::ceil(left / allowed_step(*this, ambient_pressure));
    const double step = n_steps > 1. ? left / n_steps : left;
    take_step(*this,
              first + slope * time,
              first + slope * (time + 0.5 * step),
              first + slope * (time + step),
              step,
              ambient_pressure);
    time = n_steps > 1. ? time + step : duration;
  }
}


ChestWallResponse chest_wall_response(const std::vector<double> &times,
                                      const std::vector<double> &overpressures,
                                      const double ambient_pressure)
{
  if (times.size() != overpressures.size())
    throw InputError("chest wall: " + std::to_string(times.size()) +
                     " times, but " + std::to_string(overpressures.size()) +
                     " overpressures");
  ChestWall wall;
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
  {
    const double duration = times[i + 1] - times[i];
    if (!(duration > 0.))
      throw InputError("chest wall: the times of a load must increase");
    wall.advance(
      overpressures[i], overpressures[i + 1], duration, ambient_pressure);
  }
  return {wall.largest_velocity,
          wall.largest_displacement,
          lung_pressure(wall.largest_displacement, ambient_pressure) -
            ambient_pressure,
          wall.is_fastest_now()};
}


double thorax_injury_index(const double chest_wall_velocity)
{
  return std::pow(0.124 + 0.117 * chest_wall_velocity, 2.63);
}
} // namespace contrecoup

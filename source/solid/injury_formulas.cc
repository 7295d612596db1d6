// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/injury_formulas.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::solid
{
namespace
{
  constexpr double gravity = 9.80665;
} // namespace


double head_injury_criterion(const std::vector<double> &times,
                             const std::vector<std::array<double, 3>> &speeds,
                             const double window)
{
  // The magnitude of acceleration, integrated over time.
  std::vector<double> integral(times.size(), 0.);
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    double square = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      square += std::pow(speeds[i][d] - speeds[i - 1][d], 2);
    integral[i] = integral[i - 1] + std::sqrt(square) / gravity;
  }
  double largest = 0.;
  for (std::size_t i = 0; i < times.size(); ++i)
    for (std::size_t j = i + 1;
         j < times.size() && times[j] - times[i] <= window * (1. + 1e-12);
         ++j)
    {
      const double length = times[j] - times[i];
      largest = std::max(
        largest, length * std::pow((integral[j] - integral[i]) / length, 2.5));
    }
  return largest;
}


double brain_injury_criterion(const std::array<double, 3> &largest)
{
  constexpr double critical[] = {66.25, 56.45, 42.87};
  double sum = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    sum += std::pow(largest[d] / critical[d], 2);
  return std::sqrt(sum);
}


double chest_wall_velocity(const std::function<double(double)> &overpressure,
                           const double end)
{
  constexpr double area = 0.082, mass = 2.03, damping = 696., spring = 989.,
                   volume = 1.82e-3, exponent = 1.2, ambient = 101325.;
  const auto acceleration =
    [&](const double time, const double x, const double v) {
      const double left = std::max(volume - area * x, 1e-3 * volume);
      const double force = area * (overpressure(time) + ambient -
                                   ambient * std::pow(volume / left, exponent));
      return (force - damping * v - spring * x) / mass;
    };
  const double step = std::min(5e-6, end / 100.);
  double x = 0., v = 0., largest = 0.;
  for (double time = 0.; time < end; time += step)
  {
    // The classical Runge-Kutta scheme.
    const double v1 = v, a1 = acceleration(time, x, v);
    const double v2 = v + 0.5 * step * a1,
                 a2 = acceleration(time + 0.5 * step, x + 0.5 * step * v1, v2);
    const double v3 = v + 0.5 * step * a2,
                 a3 = acceleration(time + 0.5 * step, x + 0.5 * step * v2, v3);
    const double v4 = v + step * a3,
                 a4 = acceleration(time + step, x + step * v3, v4);
    x += step / 6. * (v1 + 2. * v2 + 2. * v3 + v4);
    v += step / 6. * (a1 + 2. * a2 + 2. * a3 + a4);
    largest = std::max(largest, v);
  }
  return largest;
}


double adjusted_severity_index(const double velocity)
{
  return std::pow(0.124 + 0.117 * velocity, 2.63);
}


double half_lethal_overpressure(const double duration, const double mass)
{
  constexpr double pound_per_square_inch = 6894.757;
  const double scaled = 1e3 * duration * std::cbrt(70. / mass);
  return 61.5 * pound_per_square_inch * (1. + 6.76 * std::pow(scaled, -1.064));
}


double eardrum_rupture(const double peak)
{
  if (!(peak > 0.))
    return 0.;
  const double probit = -12.6 + 1.524 * std::log(peak);
  return 0.5 * std::erfc(-(probit - 5.) / std::sqrt(2.));
}


double volume_percentile(std::vector<std::pair<double, double>> values,
                         const double part)
{
  std::sort(values.begin(), values.end());
  double total = 0.;
  for (const auto &[value, volume] : values)
    total += volume;
  double sum = 0.;
  for (const auto &[value, volume] : values)
  {
    sum += volume;
    if (sum >= part * total)
      return value;
  }
  return 0.;
}
} // namespace contrecoup::solid

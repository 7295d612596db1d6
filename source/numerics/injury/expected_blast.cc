// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/injury/expected_blast.h>

#include <cmath>

namespace contrecoup
{
namespace
{
  constexpr double gamma = PointSourceSolution::gamma;

  /// Heat capacity at constant volume times temperature, over the gas constant
  /// [K]: rotation, and vibration of molecules.
  double energy_of_air(const double temperature)
  {
    const auto oscillator = [&](const double characteristic) {
      return characteristic / std::expm1(characteristic / temperature);
    };
    return 2.5 * temperature + 0.79 * oscillator(3390.) +
           0.21 * oscillator(2270.);
  }
} // namespace

ExpectedBlast::ExpectedBlast(const double energy,
                             const double pressure,
                             const double density)
  : source_(energy, pressure, density)
  , sound_speed_(std::sqrt(gamma * pressure / density))
{}

double ExpectedBlast::arrival(const double distance) const
{
  const double first = source_.smallest_radius();
  const double last = source_.largest_radius();
  if (distance <= first)
    return source_.arrival_time(first) * std::pow(distance / first, 2.5);
  if (distance >= last)
    return source_.arrival_time(last) + (distance - last) / sound_speed_;
  return source_.arrival_time(distance);
}

double ExpectedBlast::overpressure(const double distance) const
{
  const double first = source_.smallest_radius();
  const double last = source_.largest_radius();
  if (distance <= first)
    return source_.overpressure(first) * std::pow(first / distance, 3);
  if (distance >= last)
    return source_.overpressure(last) * last / distance;
  return source_.overpressure(distance);
}

double ExpectedBlast::radius(const double time) const
{
  // No shock is slower than sound, so the initial bounds enclose the root.
  double low = 0., high = source_.smallest_radius();
  while (arrival(high) < time)
    high *= 2.;
  while (high - low > 1e-12 * high)
  {
    const double middle = 0.5 * (low + high);
    (arrival(middle) < time ? low : high) = middle;
  }
  return high;
}

double speed_behind_shock(const double overpressure,
                          const double pressure,
                          const double density)
{
  const double sound_speed = std::sqrt(gamma * pressure / density);
  const double strength = overpressure / pressure;
  return sound_speed * strength / gamma /
         std::sqrt(1. + (gamma + 1.) / (2. * gamma) * strength);
}

double excess_pressure_of_perfect_air(const double overpressure,
                                      const double pressure,
                                      const double density)
{
  // Specific gas constant of air [J/(kg K)].
  constexpr double gas_constant = 287.05;
  const double ratio = 1. + overpressure / pressure;
  const double limit = (gamma + 1.) / (gamma - 1.);
  const double compression = (1. + limit * ratio) / (limit + ratio);
  const double ambient = pressure / (density * gas_constant);
  const double temperature = ambient * ratio / compression;
  // The vibrational energy of the gas ahead counts as well.
  const double energy =
    2.5 * temperature + energy_of_air(ambient) - 2.5 * ambient;
  double low = 0., high = temperature * 1.01;
  while (high - low > 1e-9 * temperature)
  {
    const double middle = 0.5 * (low + high);
    (energy_of_air(middle) < energy ? low : high) = middle;
  }
  return temperature / high - 1.;
}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/injury/blast_injury.h>
#include <contrecoup/numerics/injury/wave_reflection.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
namespace
{
  /// Speed of a shock by its overpressure in parts of the ambient pressure
  /// (Rankine-Hugoniot) [m/s].
  double front_speed(const double over)
  {
    constexpr double sound_speed = 340.;
    return sound_speed * std::sqrt(1. + 6. / 7. * over);
  }

  /// Speed of a shock of the same overpressure in the flow behind that one
  /// [m/s].
  double following_speed(const double over)
  {
    const double squared = 1. + 6. / 7. * over;
    const double compression = 6. * squared / (squared + 5.);
    return front_speed(over) * (1. - 1. / compression) +
           std::sqrt((1. + over) / compression) *
             front_speed(over / (1. + over));
  }

  /// Earliest arrival of a reflection at the distance @p way from the charge's
  /// image; the plane is at the distance @p plane on this way [m].
  double earliest_reflection(const IncidentWave &wave,
                             const double plane,
                             const double way)
  {
    constexpr unsigned int n_steps = 200;
    const double step = (way - plane) / n_steps;
    double time = wave.value(BlastQuantity::arrival, plane);
    for (unsigned int i = 0; i < n_steps; ++i)
      time += step / following_speed(wave.value(BlastQuantity::overpressure,
                                                plane + (i + 0.5) * step) /
                                     sea_level_pressure);
    return time;
  }

  constexpr double energy_of_tnt = 4.184e6; // [J/kg]

  IncidentWave wave_of_tnt(const double energy)
  {
    return {{1., 1., true, ""}, energy / energy_of_tnt, energy};
  }

  /// Length of a blast over that of the same energy at sea level (Sachs).
  double length_scale(const double pressure)
  {
    return std::cbrt(sea_level_pressure / pressure);
  }
} // namespace


double ReflectionWay::mirrored() const
{
  return std::sqrt(direct * direct + 4. * before * behind);
}


ReflectionDelay reflection_delay(const IncidentWave &wave,
                                 const ReflectionWay &way)
{
  // Error of the tables' arrivals.
  constexpr double accuracy = 0.05;
  const double mirrored = way.mirrored();
  const double to_plane =
    std::clamp(mirrored * way.before / (way.before + way.behind),
               std::min(wave.charge_radius(), mirrored),
               mirrored);
  const double arrival = wave.value(BlastQuantity::arrival, way.direct);
  const double delay = earliest_reflection(wave, to_plane, mirrored) - arrival;
  return {std::max(delay, 0.), delay <= accuracy * arrival};
}


bool merges_with_reflection(const double energy,
                            const double pressure,
                            const ReflectionWay &way)
{
  const double scale = length_scale(pressure);
  const ReflectionWay scaled{
    way.direct / scale, way.before / scale, way.behind / scale};
  return IncidentWave::is_surface_burst(
           energy / energy_of_tnt, scaled.before, scaled.direct) ||
         reflection_delay(wave_of_tnt(energy), scaled).merges;
}


double earliest_front(const double energy,
                      const double pressure,
                      const double density,
                      const double distance)
{
  constexpr double air_density = 1.225;
  const double length = length_scale(pressure);
  const double time =
    length * std::sqrt(sea_level_pressure / air_density / (pressure / density));
  return std::min(ExpectedBlast(energy, pressure, density).arrival(distance),
                  time * wave_of_tnt(energy).value(BlastQuantity::arrival,
                                                   distance / length));
}
} // namespace contrecoup

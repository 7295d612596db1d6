// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/injury/blast_injury.h>
#include <contrecoup/numerics/injury/incident_wave.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup
{
namespace
{
  constexpr double air_density = 1.225; // [kg/m^3]
  constexpr double step = 1.02;         ///< ratio of distances that are tried

  /// Nearest distance to @p distance that @p covers, to 1e-6 of it; some
  /// distance beyond @p inside is covered, or @p inside is.
  template <typename Covers>
  double
  nearest_covered(const Covers &covers, const double inside, double distance)
  {
    double outside = distance;
    while (!covers(distance))
    {
      outside = distance;
      distance *= distance < inside ? step : 1. / step;
    }
    for (double middle = 0.5 * (outside + distance);
         std::abs(distance - outside) > 1e-6 * distance;
         middle = 0.5 * (outside + distance))
      (covers(middle) ? distance : outside) = middle;
    return distance;
  }
} // namespace


IncidentWave::IncidentWave(const TntEquivalence &tnt,
                           const double mass,
                           const double energy,
                           const bool is_surface_burst)
  : of_pressure_(tables_for(is_surface_burst), tnt.pressure * mass)
  , of_impulse_(tables_for(is_surface_burst), tnt.impulse * mass)
  , source_((is_surface_burst ? surface_mass : 1.) * energy,
            sea_level_pressure,
            air_density)
{}


bool IncidentWave::is_surface_burst(const double tnt_mass,
                                    const double height,
                                    const double distance)
{
  return height <= surface_height * std::cbrt(tnt_mass) &&
         distance >= surface_distance * height;
}


double IncidentWave::charge_radius() const
{
  constexpr double radius = 0.053; // of a kilogram
  return radius * of_pressure_.scaling_length();
}


std::string IncidentWave::tables_for(const bool is_surface_burst)
{
  return is_surface_burst ? "hemispherical" : "spherical";
}


const KingeryBulmash &IncidentWave::tables(const BlastQuantity quantity) const
{
  switch (quantity)
  {
    case BlastQuantity::impulse:
    case BlastQuantity::reflected_impulse:
    case BlastQuantity::duration:
      return of_impulse_;
    default:
      return of_pressure_;
  }
}


bool IncidentWave::is_tabulated(const BlastQuantity quantity,
                                const double distance) const
{
  return tables(quantity).covers(quantity, distance);
}


bool IncidentWave::is_tabulated(const double distance) const
{
  const auto quantities = {BlastQuantity::overpressure,
                           BlastQuantity::reflected_overpressure,
                           BlastQuantity::arrival,
                           BlastQuantity::impulse,
                           BlastQuantity::duration};
  return std::all_of(
    quantities.begin(), quantities.end(), [&](const BlastQuantity quantity) {
      return is_tabulated(quantity, distance);
    });
}


double IncidentWave::nearest_tabulated(const double distance) const
{
  return nearest_covered(
    [&](const double tried) { return is_tabulated(tried); },
    of_impulse_.scaling_length(),
    distance);
}


double IncidentWave::nearest_tabulated(const BlastQuantity quantity,
                                       const double distance) const
{
  return nearest_covered(
    [&](const double tried) { return is_tabulated(quantity, tried); },
    of_impulse_.scaling_length(),
    distance);
}


double IncidentWave::value(const BlastQuantity quantity,
                           const double distance) const
{
  if (is_tabulated(quantity, distance))
    return tables(quantity).value(quantity, distance);
  if (quantity != BlastQuantity::overpressure &&
      quantity != BlastQuantity::arrival)
    return std::numeric_limits<double>::quiet_NaN();

  const double end = nearest_tabulated(quantity, distance);
  const double at_end = tables(quantity).value(quantity, end);
  if (quantity == BlastQuantity::overpressure)
    return at_end * source_.overpressure(distance) / source_.overpressure(end);
  const double source_at_end = source_.arrival(end);
  return distance > end ? at_end + source_.arrival(distance) - source_at_end
                        : at_end * source_.arrival(distance) / source_at_end;
}


double IncidentWave::nearest_duration(const double distance) const
{
  return of_impulse_.value(
    BlastQuantity::duration,
    nearest_tabulated(BlastQuantity::duration, distance));
}
} // namespace contrecoup

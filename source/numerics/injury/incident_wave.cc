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


double IncidentWave::nearest_tabulated(double distance) const
{
  double outside = distance;
  while (!is_tabulated(distance))
  {
    outside = distance;
    distance *= distance < of_impulse_.scaling_length() ? step : 1. / step;
  }
  for (double middle = 0.5 * (outside + distance);
       std::abs(distance - outside) > 1e-6 * distance;
       middle = 0.5 * (outside + distance))
    (is_tabulated(middle) ? distance : outside) = middle;
  return distance;
}


double IncidentWave::value(const BlastQuantity quantity,
                           const double distance) const
{
  if (is_tabulated(quantity, distance))
    return tables(quantity).value(quantity, distance);
  if (quantity == BlastQuantity::overpressure)
    return source_.overpressure(distance);
  if (quantity == BlastQuantity::arrival)
    return source_.arrival(distance);
  return std::numeric_limits<double>::quiet_NaN();
}


double IncidentWave::nearest_duration(double distance) const
{
  while (!is_tabulated(BlastQuantity::duration, distance))
    distance *= distance < of_impulse_.scaling_length() ? step : 1. / step;
  return of_impulse_.value(BlastQuantity::duration, distance);
}
} // namespace contrecoup

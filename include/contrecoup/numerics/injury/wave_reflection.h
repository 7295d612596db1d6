// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/injury/incident_wave.h>

namespace contrecoup
{
/// Energy of a wave in a run that has merged with its reflection by a rigid
/// plane, over that of the charge: the image adds its own. Real ground takes
/// some of it, see IncidentWave::surface_mass.
constexpr double energy_with_image = 2.;

/// Way of a wave from its charge to a place in front of a rigid plane, which
/// reflects it as if the charge had an image behind the plane.
struct ReflectionWay
{
  double direct; ///< from the charge to the place [m]
  double before; ///< from the charge straight to the plane [m]
  double behind; ///< from the plane straight to the place [m]

  /// From the image to the place [m].
  double mirrored() const;
};

/// Delay between the incident wave at a place and its reflection by a plane.
struct ReflectionDelay
{
  /// Least delay [s]: the wave goes to the plane as the front, and from there
  /// through the flow behind the front as a shock of the same strength.
  double least;
  /// Whether the reflection may have merged with the incident wave: its least
  /// delay is within the error of the tables' arrivals.
  bool merges;
};

ReflectionDelay reflection_delay(const IncidentWave &wave,
                                 const ReflectionWay &way);

/// Whether the wave of a blast of any charge in free air has merged with its
/// reflection by a plane, as that of TNT of the same energy would; for energy
/// and pressure see earliest_front().
bool merges_with_reflection(double energy,
                            double pressure,
                            const ReflectionWay &way);

/**
 * Earliest arrival at @p distance of the front of a blast of any charge in free
 * air [s]: that of the point source or, if earlier, of TNT of the same energy
 * (4.184 MJ/kg) by the tables. For ANFO and PETN the tables arrive up to 6 %
 * before the point source, at 2 to 3 m/kg^(1/3), runs of ANFO up to 2 %.
 * @param energy [J], ambient @p pressure [Pa] and @p density [kg/m^3], for
 * which the tables are scaled (Sachs)
 */
double
earliest_front(double energy, double pressure, double density, double distance);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <map>
#include <string>

namespace contrecoup::coupling
{
/// Measurements by stages of a scene, by their folders; NaN is unknown.

/// The value of that name among the results in a stage's summary, in SI units.
double stage_result(const std::string &folder, const std::string &name);

/// All results in a stage's summary that have values, by their names.
std::map<std::string, double> stage_results(const std::string &folder);

/// The same among its checks.
double stage_check(const std::string &folder, const std::string &name);

/// Projections of the skin of the body that anatomy has meshed on the three
/// planes of coordinates, summed [m^2].
double skin_projections(const std::string &folder);

/// Largest overpressure at the gauges of the trunk [Pa].
double largest_trunk_peak(const std::string &folder);

/// Largest motion of a body.
struct BodyMotion
{
  double displacement; ///< at its probes or of its centre of mass [m]
  double speed;        ///< of its centre of mass [m/s]
};

/// Motion in the tables of biomechanics.
/// @param last time until which the displacement counts [s]
/// @throws InputError for damaged tables
BodyMotion measure_motion(const std::string &folder, double last);
} // namespace contrecoup::coupling

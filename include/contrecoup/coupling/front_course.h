// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <utility>
#include <vector>

namespace contrecoup::coupling
{
/**
 * How a blast's front goes on, from how it went: its distance is a power of
 * time, whose exponent is that of the last half of the course, from 0.4 of a
 * strong blast (Sedov 1946) to 1 of sound.
 */
class FrontCourse
{
public:
  /// Takes the front's @p distance [m] at @p time [s]; meshes show it in jumps,
  /// and only these count.
  void add(const double time, const double distance);

  /// When the front will be at @p distance [s]; NaN before its second jump.
  double arrival(const double distance) const;

private:
  std::vector<std::pair<double, double>> jumps_; ///< times and distances
};
} // namespace contrecoup::coupling

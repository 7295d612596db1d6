// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <utility>
#include <vector>

namespace contrecoup::coupling
{
/**
 * Extrapolates the path of a blast front: the distance is taken as a power of
 * time, with the exponent of the second half of the recorded path, between 0.4
 * (strong blast, Sedov 1946) and 1 (sound).
 */
class FrontPath
{
public:
  /// Adds the front's @p distance [m] at @p time [s]. On a mesh the front
  /// advances in jumps; only increases are stored.
  void add(const double time, const double distance);

  /// Predicted time of arrival at @p distance [m] [s]; NaN before the second
  /// jump.
  double arrival(const double distance) const;

private:
  /// Times [s] and distances [m]
  std::vector<std::pair<double, double>> jumps_;
};
} // namespace contrecoup::coupling

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace contrecoup::ale
{
/// Largest running mean over `span` of a force that is constant in each step
/// and zero before the first one; a window begins at a multiple of an
/// interval, a fiftieth of it. Plain data, written to checkpoints.
struct LargestMean
{
  static constexpr double span = 5e-5; ///< [s]
  static constexpr std::int64_t n_intervals = 50;
  static constexpr double interval = span / n_intervals; ///< [s]

  double value = 0.; ///< [N]
  double time = 0.;  ///< middle of its window [s]
  /// Impulses of the last intervals, by number modulo n_intervals [N s].
  std::array<double, n_intervals> impulses{};
  std::int64_t latest = -1; ///< number of the last interval with an impulse

  /// Adds a step of size @p step that ended at @p end [s].
  void add(const double force, const double end, const double step)
  {
    const double begin = std::max(0., end - step);
    const auto last = static_cast<std::int64_t>(end / interval);
    // Only the end of a step that is longer than the span counts.
    for (auto k = std::max(static_cast<std::int64_t>(begin / interval),
                           last - n_intervals);
         k <= last;
         ++k)
    {
      double &impulse = impulses[k % n_intervals];
      if (k > latest)
        impulse = 0.;
      latest = std::max(latest, k);
      const double until = std::min(end, (k + 1) * interval);
      impulse += force * std::max(0., until - std::max(begin, k * interval));
      const double mean =
        std::accumulate(impulses.begin(), impulses.end(), 0.) / span;
      // A constant force counts when it is first reached.
      if (mean > (1. + 1e-9) * value)
      {
        value = mean;
        time = std::max(0., (k + 1) * interval - 0.5 * span);
      }
    }
  }
};
} // namespace contrecoup::ale

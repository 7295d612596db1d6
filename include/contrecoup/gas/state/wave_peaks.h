// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/state/blast_record.h>

#include <algorithm>
#include <limits>

namespace contrecoup::gas
{
/**
 * Peaks of the first wave at one position and of those that follow it, updated
 * once per step after the BlastRecord there, whose peak is the largest of all.
 * The first wave ends as its first rise does; a later one rises by a tenth of
 * the first peak at least, which no oscillation behind a front does.
 */
struct WavePeaks
{
  double first = 0.;      ///< overpressure [Pa]
  double later = 0.;      ///< largest of later waves [Pa]; 0: none so far
  double later_time = 0.; ///< [s]
  /// Overpressure since the first rise [Pa].
  double lowest = std::numeric_limits<double>::infinity();

  /// Adds the overpressure [Pa] at the end @p time of a step [s].
  void add(const double overpressure,
           const double time,
           const BlastRecord<double> &record)
  {
    if (!(record.peak > 0.))
      return;
    if (record.arrival <= 0.)
    {
      first = record.peak;
      return;
    }
    lowest = std::min(lowest, overpressure);
    constexpr double notable = 0.1;
    if (overpressure > later && overpressure - lowest > notable * first)
    {
      later = overpressure;
      later_time = time;
    }
  }
};
} // namespace contrecoup::gas

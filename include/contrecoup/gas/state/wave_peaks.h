// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/state/blast_record.h>

#include <algorithm>
#include <limits>

namespace contrecoup::gas
{
/**
 * Peaks of the first wave at one position and of those that follow it, and the
 * impulse of the first, updated once per step after the BlastRecord there,
 * whose peak is the largest of all and whose impulse that of its positive
 * phase. The first wave ends as its first rise does; a later one rises by a
 * tenth of the first peak at least, which no oscillation behind a front does.
 */
struct WavePeaks
{
  double first = 0.;      ///< overpressure [Pa]
  double later = 0.;      ///< largest of later waves [Pa]; 0: none so far
  double later_time = 0.; ///< [s]
  /// Least overpressure since the first rise [Pa].
  double lowest = std::numeric_limits<double>::infinity();
  /// Until when the front may rise once more, since it was handed on to other
  /// cells that smear it [s].
  double smeared_until = 0.;
  /// Positive impulse up to the least overpressure before any later wave [Pa
  /// s].
  double first_impulse = 0.;

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
    if (time < smeared_until)
      return;
    if (overpressure < lowest)
    {
      lowest = overpressure;
      if (later == 0.)
        first_impulse = record.running;
    }
    constexpr double notable = 0.1;
    if (overpressure > later && overpressure - lowest > notable * first)
    {
      later = overpressure;
      later_time = time;
    }
  }

  /// Part of the @p total positive impulse [Pa s] that belongs to the first
  /// wave, where @p impulse is that of the first positive phase [Pa s]: 1 in a
  /// simple wave.
  double first_fraction(const double impulse, const double total) const
  {
    if (!(total > 0.))
      return 1.;
    return (later > 0. ? std::min(first_impulse, impulse) : impulse) / total;
  }
};
} // namespace contrecoup::gas

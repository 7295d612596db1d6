// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/config.h>

namespace contrecoup::gas
{
/// What a blast wave has done at a place.
struct BlastMeasures
{
  double peak = 0.;     ///< largest overpressure [Pa]
  double impulse = 0.;  ///< of the positive phase so far [Pa s]
  double arrival = 0.;  ///< [s]; 0 where nothing arrived yet
  double duration = 0.; ///< of the positive phase so far [s]
};


/**
 * Follows the overpressure at a place, step by step.
 *
 * A blast arrives when the overpressure first exceeds `threshold`. Its
 * arrival is the middle of the first rise: the mean time of the rise, each
 * moment weighted with the increase of pressure there, which in a smeared
 * shock is the place of the shock. The first rise ends when the overpressure
 * has fallen by a tenth below its peak. The positive phase lasts from the
 * arrival until the overpressure first falls to zero after its largest peak;
 * the impulse is the time integral of the overpressure, where positive, over
 * this phase. A later, larger peak prolongs the phase.
 */
template <typename Number>
struct BlastRecord
{
  static constexpr unsigned int n_values = 5;

  /// Part of the ambient pressure that overpressures must exceed to count:
  /// above the noise of any scheme, below any blast of interest.
  static constexpr double threshold = 1e-3;

  Number peak = 0.;    ///< largest overpressure so far [Pa]
  Number arrival = 0.; ///< [s]; negative while the first rise goes on
  Number running = 0.; ///< integral of overpressure since arrival [Pa s]
  Number impulse = 0.; ///< the same up to @p end [Pa s]
  Number end = 0.;     ///< of the positive phase [s]; 0 while it lasts

  /// Takes the overpressure at the end @p time of a step, both [s]; without
  /// branches, so that loops over records vectorise.
  DEAL_II_ALWAYS_INLINE void add(const Number overpressure,
                                 const Number time,
                                 const Number step,
                                 const Number smallest)
  {
    const Number zero(0.);
    const Number middle = time - Number(0.5) * step;
    const bool is_higher = overpressure > peak && overpressure > smallest;
    const bool is_rising = arrival <= zero;
    const Number part =
      (overpressure - peak) / (is_higher ? overpressure : Number(1.));
    const Number moved = arrival - (middle + arrival) * part;
    arrival = is_higher && is_rising ? moved : arrival;
    peak = is_higher ? overpressure : peak;
    const bool is_over = overpressure < Number(0.9) * peak;
    arrival = arrival < zero && is_over ? -arrival : arrival;
    running += peak > zero && overpressure > zero ? overpressure * step : zero;
    end = is_higher ? zero : end;
    const bool closes = overpressure <= zero && peak > zero && end == zero;
    impulse = closes ? running : impulse;
    end = closes ? middle : end;
  }

  /// What is known at @p time.
  BlastMeasures measures(const double time) const
  {
    BlastMeasures result;
    result.peak = peak;
    if (peak > Number(0.))
    {
      result.arrival = arrival < Number(0.) ? -arrival : arrival;
      result.impulse = end > Number(0.) ? impulse : running;
      result.duration = (end > Number(0.) ? end : time) - result.arrival;
    }
    return result;
  }
};
} // namespace contrecoup::gas

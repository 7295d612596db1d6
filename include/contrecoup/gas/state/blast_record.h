// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/config.h>

namespace contrecoup::gas
{
/// Peak, impulse, arrival and duration of a blast wave at one position.
struct BlastMeasures
{
  double peak = 0.;     ///< peak overpressure [Pa]
  double impulse = 0.;  ///< impulse of the positive phase so far [Pa s]
  double arrival = 0.;  ///< time of arrival [s]; 0 before arrival
  double duration = 0.; ///< duration of the positive phase so far [s]
};


/**
 * Running record of the overpressure at one position, updated once per step.
 *
 * The blast arrives when the overpressure first exceeds `threshold` times the
 * ambient pressure. The time of arrival is the middle of the first rise: the
 * mean time of the rise weighted with the pressure increments, which in a
 * smeared shock is the arrival of the shock. The first rise ends when the
 * overpressure has fallen below 0.9 of its peak. The positive phase lasts from
 * the arrival until the overpressure first falls to zero after its peak; the
 * impulse is the time integral of the positive overpressure over this phase. A
 * later, larger peak prolongs the phase.
 */
template <typename Number>
struct BlastRecord
{
  static constexpr unsigned int n_values = 5;

  /// Smallest overpressure that counts, as a fraction of the ambient pressure:
  /// above the numerical noise of any scheme, below any blast of interest.
  static constexpr double threshold = 1e-3;

  Number peak = 0.;    ///< peak overpressure so far [Pa]
  Number arrival = 0.; ///< time of arrival [s]; negated during the first rise
  /// Integral of positive overpressure since arrival [Pa s]
  Number running = 0.;
  Number impulse = 0.; ///< value of running at @p end [Pa s]
  Number end = 0.;     ///< end of the positive phase [s]; 0 while it lasts

  /// Adds the overpressure [Pa] at the end @p time of a step of length @p
  /// step, both [s]. Overpressures up to @p smallest [Pa] do not raise the
  /// peak. Free of branches, so that loops over records vectorise.
  DEAL_II_ALWAYS_INLINE void add(const Number overpressure,
                                 const Number time,
                                 const Number step,
                                 const Number smallest)
  {
    const Number zero(0.);
    const Number middle = time - Number(0.5) * step;
    const bool is_higher = overpressure > peak && overpressure > smallest;
    const bool is_rising = arrival <= zero;
    const Number fraction =
      (overpressure - peak) / (is_higher ? overpressure : Number(1.));
    const Number moved = arrival - (middle + arrival) * fraction;
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

  /// Measures at @p time [s].
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

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/time_parameters.h>

#include <cstdint>

namespace contrecoup
{
/// State of the run loop besides the solver's state. Checkpoints hold it, so
/// that a resumed run makes the same steps as an uninterrupted run.
struct RunState
{
  std::uint64_t step = 0; ///< number of steps so far
  double time = 0.;       ///< simulated time [s]
  double step_size = 0.;  ///< of the last step [s]
  /// Last step size that the solver chose without a bound [s].
  double unbounded_step = 0.;
  std::uint64_t retries = 0; ///< total number of step size reductions
  double updates = 0.;       ///< total number of updated unknowns
  /// Largest number of mesh cells so far.
  std::uint64_t largest_cells = 0;
  std::uint64_t field_index = 0; ///< index of the next field output
  /// Steps of the last written rows and fields; -1: none.
  std::int64_t history_step = -1;
  std::int64_t probe_step = -1;
  std::int64_t field_step = -1;
  /// Next multiples of the output intervals; determined by the time.
  std::uint64_t field_tick = 1;
  std::uint64_t history_tick = 1;
};

/**
 * Bounds step sizes such that output times and end time are met exactly,
 * without a tiny last step: the remainder is divided between the last two
 * steps. Depends on RunState only, not on checkpoints or wall time.
 */
class TimeControl
{
public:
  explicit TimeControl(const TimeParameters &parameters);

  /// Sets output times to the next ones after state.time.
  void set_ticks(RunState &state) const;

  /// Upper bound of the next step [s].
  double bound(const RunState &state) const;

  /// Records a completed step and the bound that it had.
  void after_step(RunState &state,
                  double time,
                  double step_size,
                  double bound) const;

  bool finished(const RunState &state) const;

  /// Whether output is due now; set_ticks() then advances.
  bool history_due(const RunState &state) const;
  bool probes_due(const RunState &state) const;
  bool fields_due(const RunState &state) const;

  const TimeParameters &parameters() const;

private:
  TimeParameters parameters_;
};
} // namespace contrecoup

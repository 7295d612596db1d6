// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/time_parameters.h>

#include <cstdint>

namespace contrecoup
{
/**
 * Where a run stands: everything besides the solver's own state that the
 * further course depends on. Saved in checkpoints, so that a resumed run
 * makes the same steps as one that was never stopped.
 */
struct RunState
{
  std::uint64_t step = 0; ///< steps done
  double time = 0.;       ///< simulated time [s]
  double step_size = 0.;  ///< the last step's [s]
  /// The step size that the solver takes when nothing bounds it, as last
  /// seen [s].
  double free_step = 0.;
  std::uint64_t retries = 0;     ///< steps that were cut back, in all
  double updates = 0.;           ///< unknowns updated, in all
  std::uint64_t field_index = 0; ///< number of the next field output
  /// Steps after which rows and fields were written last; -1: never.
  std::int64_t history_step = -1;
  std::int64_t probe_step = -1;
  std::int64_t field_step = -1;
  /// Next multiples of the output intervals; follow from the time.
  std::uint64_t field_tick = 1;
  std::uint64_t history_tick = 1;
};

/**
 * Bounds step sizes so that output times and the end time are met exactly,
 * without a tiny last step: what remains is shared by the last two steps.
 * A function of RunState alone: neither checkpoints nor wall time matter.
 */
class TimeControl
{
public:
  explicit TimeControl(const TimeParameters &parameters);

  /// Sets the output ticks to the next ones after state.time.
  void set_ticks(RunState &state) const;

  /// The largest next step [s].
  double bound(const RunState &state) const;

  /// Takes note of a step that was done with the given bound.
  void after_step(RunState &state,
                  double time,
                  double step_size,
                  double bound) const;

  bool finished(const RunState &state) const;

  /// Whether output is due now; set_ticks() then moves on.
  bool history_due(const RunState &state) const;
  bool probes_due(const RunState &state) const;
  bool fields_due(const RunState &state) const;

  const TimeParameters &parameters() const;

private:
  TimeParameters parameters_;
};
} // namespace contrecoup

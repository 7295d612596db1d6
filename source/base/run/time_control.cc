// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/run/time_control.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
namespace
{
  /// Whether @p time has reached @p tick, up to round-off.
  bool reached(const double time, const double tick)
  {
    return tick - time <= 1e-13 * std::abs(tick);
  }

  /// Index of the first multiple of @p interval after @p time.
  std::uint64_t next_tick(const double time, const double interval)
  {
    if (interval <= 0.)
      return 1;
    auto tick =
      static_cast<std::uint64_t>(std::max(0., std::floor(time / interval)));
    while (reached(time, static_cast<double>(tick) * interval))
      ++tick;
    return tick;
  }

  bool every(const std::uint64_t step, const std::uint64_t n)
  {
    return n > 0 && step % n == 0;
  }
} // namespace

TimeControl::TimeControl(const TimeParameters &parameters)
  : parameters_(parameters)
{}

const TimeParameters &TimeControl::parameters() const
{
  return parameters_;
}

void TimeControl::set_ticks(RunState &state) const
{
  state.field_tick = next_tick(state.time, parameters_.fields_interval);
  state.history_tick = next_tick(state.time, parameters_.history_interval);
}

double TimeControl::bound(const RunState &state) const
{
  double target = parameters_.end_time;
  if (parameters_.fields && parameters_.fields_interval > 0.)
    target = std::min(target,
                      static_cast<double>(state.field_tick) *
                        parameters_.fields_interval);
  if (parameters_.history_interval > 0.)
    target = std::min(target,
                      static_cast<double>(state.history_tick) *
                        parameters_.history_interval);

  const double remaining = target - state.time;
  double step = remaining;
  if (remaining > state.unbounded_step && remaining < 2. * state.unbounded_step)
    step = 0.5 * remaining;
  if (parameters_.largest_step > 0.)
    step = std::min(step, parameters_.largest_step);
  return step;
}

void TimeControl::after_step(RunState &state,
                             const double time,
                             const double step_size,
                             const double bound) const
{
  if (step_size < bound * (1. - 1e-12))
    state.unbounded_step = step_size;
  else
    state.unbounded_step = std::max(state.unbounded_step, step_size);
  state.time = time;
  state.step_size = step_size;
  ++state.step;
}

bool TimeControl::finished(const RunState &state) const
{
  return reached(state.time, parameters_.end_time) ||
         (parameters_.largest_number_of_steps > 0 &&
          state.step >= parameters_.largest_number_of_steps);
}

bool TimeControl::history_due(const RunState &state) const
{
  if (parameters_.history_interval > 0.)
    return reached(state.time,
                   static_cast<double>(state.history_tick) *
                     parameters_.history_interval);
  return every(state.step, parameters_.history_every_steps);
}

bool TimeControl::probes_due(const RunState &state) const
{
  return every(state.step, parameters_.probes_every_steps);
}

bool TimeControl::fields_due(const RunState &state) const
{
  return parameters_.fields &&
         ((parameters_.fields_interval > 0. &&
           reached(state.time,
                   static_cast<double>(state.field_tick) *
                     parameters_.fields_interval)) ||
          every(state.step, parameters_.fields_every_steps));
}
} // namespace contrecoup

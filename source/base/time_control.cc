// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/base/text.h>
#include <contrecoup/base/time_control.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
namespace
{
  /// Whether @p time is @p tick or later, but for rounding.
  bool reached(const double time, const double tick)
  {
    return tick - time <= 1e-13 * std::abs(tick);
  }

  /// The first multiple of @p interval after @p time.
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

void TimeParameters::declare_parameters(ParameterHandler &prm)
{
  constexpr int many = std::numeric_limits<int>::max();
  {
    Section section(prm, "Time");
    declare_double(
      prm, "End time", "1", 0., unbounded, "s", "Simulated time at the end.");
    declare_double(prm,
                   "Largest step",
                   "0",
                   0.,
                   unbounded,
                   "s",
                   "Bound of the step size; 0: only the solver's own.");
    declare_integer(prm,
                    "Largest number of steps",
                    "0",
                    0,
                    many,
                    "The run is finished after so many steps; 0: no bound.");
    declare_integer(prm,
                    "Steps in this run",
                    "0",
                    0,
                    many,
                    "Writes a checkpoint and stops after so many steps from "
                    "start or resume; 0: no bound.");
  }
  Section section(prm, "Output");
  declare_integer(prm,
                  "History every steps",
                  "1",
                  1,
                  many,
                  "Steps between rows of history.csv.");
  declare_double(prm,
                 "History interval",
                 "0",
                 0.,
                 unbounded,
                 "s",
                 "Time between rows of history.csv, met exactly; 0: by "
                 "steps.");
  declare_integer(prm,
                  "Probes every steps",
                  "1",
                  1,
                  many,
                  "Steps between rows of probes.csv.");
  declare_bool(prm,
               "Fields",
               "true",
               "Whether to write fields at all; at least at start and end.");
  declare_double(prm,
                 "Fields interval",
                 "0",
                 0.,
                 unbounded,
                 "s",
                 "Time between field outputs, met exactly; 0: none between "
                 "start and end.");
  declare_integer(prm,
                  "Fields every steps",
                  "0",
                  0,
                  many,
                  "Steps between field outputs; 0: not by steps.");
  declare_integer(prm,
                  "Checkpoint every steps",
                  "0",
                  0,
                  many,
                  "Steps between checkpoints; 0: not by steps.");
  declare_double(prm,
                 "Checkpoint every minutes",
                 "30",
                 0.,
                 1e6,
                 "min",
                 "Wall time between checkpoints; 0: not by wall time.");
  declare_bool(prm,
               "Checkpoint at the end",
               "false",
               "Whether a finished run leaves a checkpoint, to be resumed "
               "with a later end time.");
}

void TimeParameters::parse_parameters(ParameterHandler &prm)
{
  {
    Section section(prm, "Time");
    end_time = read_double(prm, "End time");
    largest_step = read_double(prm, "Largest step");
    largest_number_of_steps = read_unsigned(prm, "Largest number of steps");
    steps_in_this_run = read_unsigned(prm, "Steps in this run");
  }
  Section section(prm, "Output");
  history_every_steps = read_unsigned(prm, "History every steps");
  history_interval = read_double(prm, "History interval");
  probes_every_steps = read_unsigned(prm, "Probes every steps");
  fields = prm.get_bool("Fields");
  fields_interval = read_double(prm, "Fields interval");
  fields_every_steps = read_unsigned(prm, "Fields every steps");
  checkpoint_every_steps = read_unsigned(prm, "Checkpoint every steps");
  checkpoint_every_minutes = read_double(prm, "Checkpoint every minutes");
  checkpoint_at_the_end = prm.get_bool("Checkpoint at the end");
  for (const double interval : {history_interval, fields_interval})
    if (interval > 0. && end_time / interval > 1e9)
      throw InputError("an output interval of " + brief(interval) +
                       " s makes more than 1e9 outputs until the end time " +
                       brief(end_time) + " s");
}

TimeControl::TimeControl(const TimeParameters &parameters)
  : parameters_(parameters)
{}

const TimeParameters &TimeControl::parameters() const
{
  return parameters_;
}

void TimeControl::start(RunState &state) const
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
  if (remaining > state.free_step && remaining < 2. * state.free_step)
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
    state.free_step = step_size;
  else
    state.free_step = std::max(state.free_step, step_size);
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

void TimeControl::consume_ticks(RunState &state) const
{
  start(state);
}
} // namespace contrecoup

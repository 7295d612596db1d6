// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/run/progress.h>
#include <contrecoup/base/run/run_loop.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/timers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <utility>

namespace contrecoup
{
namespace
{
  // Bits that are combined over all ranks after each step.
  constexpr unsigned int stop_bit = 1;
  constexpr unsigned int checkpoint_bit = 2;
  constexpr unsigned int forecast_bit = 32;
  // If there are several signals, the first in this list counts.
  constexpr std::array<std::pair<int, unsigned int>, 3> signal_bits = {
    {{SIGINT, 4}, {SIGTERM, 8}, {SIGUSR1, 16}}};

  void require_finite(const std::vector<NamedValue> &values,
                      const RunState &state)
  {
    for (const NamedValue &value : values)
      if (!std::isfinite(value.value))
        throw NumericsError("step " + std::to_string(state.step) + " at time " +
                            exact(state.time) + " s: \"" + value.name +
                            "\" is not a finite number");
  }
} // namespace

RunLoop::RunLoop(const TimeParameters &parameters,
                 Simulation &simulation,
                 RunOutput &output,
                 Collective &collective)
  : control_(parameters)
  , simulation_(simulation)
  , output_(output)
  , collective_(collective)
{}

RunLoop::~RunLoop() = default;

RunStatus RunLoop::run(RunState &state)
{
  try
  {
    return loop(state);
  }
  catch (const NumericsError &)
  {
    write_fields_after_failure(state);
    throw;
  }
}

RunStatus RunLoop::loop(RunState &state)
{
  state.time = simulation_.time();
  state.largest_cells = std::max(state.largest_cells, simulation_.size().first);
  control_.set_ticks(state);
  first_step_ = state.step;
  begin_ = Clock::now();
  last_checkpoint_ = begin_;
  const auto &parameters = control_.parameters();
  progress_ = std::make_unique<Progress>(state.time, parameters.end_time);
  if (state.step == 0)
    collective_.run([&]() { write_all(state); });

  while (!control_.finished(state))
  {
    const unsigned int flags = collective_.run_with_flags(
      [&]() { return step(state); }, ExitCode::numerics_failed);
    if ((flags & forecast_bit) != 0)
      collective_.run([&]() {
        const auto hand_over = simulation_.expected_hand_over();
        progress_->set_forecast(
          simulation_.expected_work(hand_over.value_or(parameters.end_time)),
          hand_over);
      });
    const bool enough =
      parameters.steps_in_this_run > 0 &&
      state.step - first_step_ >= parameters.steps_in_this_run;
    const bool ended = control_.finished(state);
    if (!ended && (enough || (flags & stop_bit) != 0))
    {
      checkpoint(state);
      for (const auto &[signal, bit] : signal_bits)
        if (stop_signal_ == 0 && (flags & bit) != 0)
          stop_signal_ = signal;
      return RunStatus::stopped;
    }
    if (!ended && (flags & checkpoint_bit) != 0)
      checkpoint(state);
  }

  // Write the checkpoint first: a run resumed with a later end time must not
  // have the final rows and fields of this run in its past.
  if (parameters.checkpoint_at_the_end)
    checkpoint(state);
  collective_.run([&]() { write_all(state); });
  return RunStatus::finished;
}

unsigned int RunLoop::step(RunState &state)
{
  advance(state);
  write_due(state);
  Log::instance().check();

  const auto &parameters = control_.parameters();
  const auto passed = [](const Clock::time_point since, const double minutes) {
    using Minutes = std::chrono::duration<double, std::ratio<60>>;
    return minutes > 0. && Minutes(Clock::now() - since).count() > minutes;
  };
  unsigned int flags = 0;
  for (const auto &[signal, bit] : signal_bits)
    if (SignalGuard::stop_signal() == signal)
      flags |= stop_bit | bit;
  if (progress_->wants_forecast())
    flags |= forecast_bit;
  if (passed(begin_, parameters.minutes_in_this_run))
    flags |= stop_bit;
  if ((parameters.checkpoint_every_steps > 0 &&
       state.step % parameters.checkpoint_every_steps == 0) ||
      passed(last_checkpoint_, parameters.checkpoint_every_minutes))
    flags |= checkpoint_bit;
  return flags;
}

void RunLoop::advance(RunState &state)
{
  const double bound = control_.bound(state);
  const unsigned int dimension = simulation_.dimension();
  StepReport report;
  {
    const TimerScope timer("advance");
    report = simulation_.advance(bound);
  }
  const double time = simulation_.time();
  if (!std::isfinite(time) || !(time > state.time))
    throw NumericsError("step " + std::to_string(state.step + 1) + " at time " +
                        exact(state.time) + " s: the step size " +
                        brief(report.step_size) + " s does not move the time");
  control_.after_step(state, time, report.step_size, bound);
  state.retries += report.retries;
  state.updates += report.updates;
  {
    const TimerScope timer("adaptation");
    if (simulation_.adapt())
      state.largest_cells =
        std::max(state.largest_cells, simulation_.size().first);
  }
  progress_->step(state.step, state.time, state.step_size, report.updates);
  if (simulation_.dimension() != dimension)
    progress_->restart();
}

void RunLoop::write_due(RunState &state)
{
  if (control_.history_due(state))
    history(state);
  if (control_.probes_due(state))
    probes(state);
  if (control_.fields_due(state))
    fields(state);
  control_.set_ticks(state);
}

void RunLoop::write_all(RunState &state)
{
  history(state);
  probes(state);
  if (control_.parameters().fields)
    fields(state);
}

void RunLoop::history(RunState &state)
{
  if (state.history_step == static_cast<std::int64_t>(state.step))
    return;
  const TimerScope timer("history");
  const std::vector<NamedValue> values = simulation_.history();
  output_.write_history(state, values);
  state.history_step = static_cast<std::int64_t>(state.step);
  require_finite(values, state);
}

void RunLoop::probes(RunState &state)
{
  if (state.probe_step == static_cast<std::int64_t>(state.step))
    return;
  const TimerScope timer("probes");
  const std::vector<NamedValue> values = simulation_.probes();
  if (!values.empty())
    output_.write_probes(state, values);
  state.probe_step = static_cast<std::int64_t>(state.step);
  require_finite(values, state);
}

void RunLoop::fields(RunState &state)
{
  if (state.field_step == static_cast<std::int64_t>(state.step))
    return;
  const TimerScope timer("field output");
  output_.write_fields(state, simulation_);
  state.field_step = static_cast<std::int64_t>(state.step);
  ++state.field_index;
}

void RunLoop::checkpoint(RunState &state)
{
  const TimerScope timer("checkpoint");
  collective_.run([&]() { output_.write_checkpoint(state, simulation_); });
  last_checkpoint_ = Clock::now();
}

void RunLoop::write_fields_after_failure(RunState &state)
{
  if (!control_.parameters().fields)
    return;
  try
  {
    state.time = simulation_.time();
    state.field_step = -1;
    collective_.run([&]() { fields(state); });
  }
  catch (const std::exception &error)
  {
    log_line("The fields of the failed state could not be written: " +
             std::string(error.what()));
  }
}
} // namespace contrecoup

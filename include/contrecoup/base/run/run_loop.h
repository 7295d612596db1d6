// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/base/run/time_control.h>
#include <contrecoup/base/system/collective.h>

#include <chrono>
#include <memory>
#include <vector>

namespace contrecoup
{
class Progress;

/// Interface: output of a run loop. Every function is collective.
class RunOutput
{
public:
  virtual ~RunOutput() = default;
  virtual void write_history(const RunState &state,
                             const std::vector<NamedValue> &values) = 0;
  virtual void write_probes(const RunState &state,
                            const std::vector<NamedValue> &values) = 0;
  /// Writes field output number state.field_index.
  virtual void write_fields(const RunState &state, Simulation &simulation) = 0;
  virtual void write_checkpoint(const RunState &state,
                                Simulation &simulation) = 0;
};

enum class RunStatus
{
  finished, ///< end time or largest number of steps
  stopped ///< with a checkpoint: by a signal, "Steps" or "Minutes in this run"
};

/// The time loop of all applications: steps, adaptation, output, checkpoints,
/// signals, progress.
class RunLoop
{
public:
  RunLoop(const TimeParameters &parameters,
          Simulation &simulation,
          RunOutput &output,
          Collective &collective);
  ~RunLoop();

  /**
   * Runs from @p state to the end. A state of step 0 is a new run, whose
   * initial state is written.
   * @throws NumericsError, after writing the fields once more, when a step
   * failed or a value of the history is not finite
   */
  RunStatus run(RunState &state);

  /// Signal that stopped the run on any rank, or 0.
  int stop_signal() const
  {
    return stop_signal_;
  }

private:
  using Clock = std::chrono::steady_clock;

  RunStatus loop(RunState &state);
  unsigned int step(RunState &state);
  void advance(RunState &state);
  void write_due(RunState &state);
  void write_all(RunState &state);
  void history(RunState &state);
  void probes(RunState &state);
  void fields(RunState &state);
  void checkpoint(RunState &state);
  void write_fields_after_failure(RunState &state);

  TimeControl control_;
  Simulation &simulation_;
  RunOutput &output_;
  Collective &collective_;
  std::uint64_t first_step_ = 0;
  int stop_signal_ = 0;

  std::unique_ptr<Progress> progress_;
  Clock::time_point begin_;
  Clock::time_point last_checkpoint_;
};
} // namespace contrecoup

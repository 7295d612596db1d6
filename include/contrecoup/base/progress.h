// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/remaining_time.h>

#include <chrono>
#include <cstdint>

namespace contrecoup
{
/**
 * Shows how far a run is: step, time, step size, throughput, time left. On
 * a terminal one redrawn line, otherwise a plain line about every ten
 * seconds.
 */
class Progress
{
public:
  /// @param end_time simulated time at the end [s]
  explicit Progress(double end_time);

  /// Call after each step; draws only when it is time to.
  /// @param updates unknowns updated in this step, all ranks [-]
  void
  step(std::uint64_t number, double time, double step_size, double updates);

  /// Whether the solver should be asked anew for the work that is left.
  bool wants_forecast() const;

  /// Takes what the solver foresees, see RemainingTime.
  void expect(WorkForecast forecast);

  /// Says that another solver is at work from now on.
  void restart();

private:
  using Clock = std::chrono::steady_clock;

  RemainingTime remaining_;
  Clock::time_point last_step_;
  Clock::time_point last_line_;
  Clock::time_point last_forecast_; ///< at first long ago
  double end_time_;
  double recent_updates_ = 0.;
};
} // namespace contrecoup

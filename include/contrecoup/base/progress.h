// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/remaining_time.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

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

  /// Takes what the solver foresees, see RemainingTime: until the end, or until
  /// the first stage is expected to end @p hand_over [s].
  void expect(WorkForecast forecast, std::optional<double> hand_over);

  /// Says that another solver is at work from now on.
  void restart();

private:
  std::string time_left(double time) const;

  using Clock = std::chrono::steady_clock;

  RemainingTime remaining_;
  Clock::time_point last_step_;
  Clock::time_point last_line_;
  Clock::time_point last_forecast_; ///< at first long ago
  double end_time_;
  std::optional<double> hand_over_; ///< of a first stage that is at work [s]
  double recent_updates_ = 0.;
};
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/remaining_time.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace contrecoup
{
/**
 * Displays the progress of a run: how much of the simulated time has passed
 * and the time left, on a terminal as one redrawn line, otherwise as a line at
 * each quarter, or at half of the time of a part of the run (see Log), unless
 * the run is short. The log gets a line about every ten seconds, with step
 * size and throughput, which a verbose screen shows too.
 */
class Progress
{
public:
  /// @param begin_time, end_time simulated times [s]
  Progress(double begin_time, double end_time);

  /// Call after each step; draws at intervals.
  /// @param updates unknowns updated in this step, all ranks [-]
  void
  step(std::uint64_t number, double time, double step_size, double updates);

  /// Whether a new forecast of the remaining work is due.
  bool wants_forecast() const;

  /// Sets the solver's forecast, see RemainingTime: until the end, or until
  /// the expected end of the first stage @p hand_over [s].
  void set_forecast(WorkForecast forecast, std::optional<double> hand_over);

  /// Call when another solver takes over.
  void restart();

private:
  std::string time_left(double time) const;
  std::string brief_state(std::uint64_t number, double time) const;
  void show_quarter(std::uint64_t number, double time);

  using Clock = std::chrono::steady_clock;

  RemainingTime remaining_;
  Clock::time_point last_step_;
  Clock::time_point last_line_;
  Clock::time_point last_quarter_;  ///< when the screen got a line, or begin
  Clock::time_point last_forecast_; ///< initially long ago
  double end_time_;
  std::optional<double> hand_over_; ///< of a running first stage [s]
  double recent_updates_ = 0.;
  double begin_time_;         ///< [s]
  unsigned int quarters_ = 0; ///< that have passed
};
} // namespace contrecoup

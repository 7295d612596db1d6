// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

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
  /// @param start_time simulated time now [s]
  /// @param end_time simulated time at the end [s]
  Progress(double start_time, double end_time);

  /// Call after each step; draws only when it is time to.
  /// @param updates unknowns updated in this step, all ranks [-]
  void
  step(std::uint64_t number, double time, double step_size, double updates);

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point begin_;
  Clock::time_point last_;
  double start_time_;
  double end_time_;
  double recent_updates_ = 0.;
};
} // namespace contrecoup

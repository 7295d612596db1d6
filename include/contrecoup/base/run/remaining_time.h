// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <utility>
#include <vector>

namespace contrecoup
{
/// Ends of successive intervals of simulated time [s], each with the work per
/// second of simulated time [unknown updates/s]; NaN: unknown.
using WorkForecast = std::vector<std::pair<double, double>>;

/// Estimates the remaining wall time of a run: the work forecast of the solver
/// times the recent cost of an unknown update.
class RemainingTime
{
public:
  /// Records a step.
  /// @param step_size simulated time [s]
  /// @param updates unknowns updated [-]
  /// @param cost wall time of the step, including output [s]
  void add(double step_size, double updates, double cost);

  /// Sets the solver's forecast; empty: recent cost per second of simulated
  /// time.
  void set_forecast(WorkForecast forecast)
  {
    forecast_ = std::move(forecast);
  }

  /// Discards recorded costs, because another solver takes over; the forecast
  /// remains until the next one.
  void restart();

  /// Remaining wall time from @p time to @p end [s]; NaN if unknown.
  double left(double time, double end) const;

private:
  WorkForecast forecast_;
  /// Sums over the steps, with exponentially decaying weights.
  double time_ = 0.;    ///< simulated [s]
  double updates_ = 0.; ///< [-]
  double cost_ = 0.;    ///< [s]
};
} // namespace contrecoup

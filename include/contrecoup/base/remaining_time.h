// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <utility>
#include <vector>

namespace contrecoup
{
/// Ends of intervals of simulated time [s], one after the other, and the work
/// that a second in each of them will take [unknown updates/s]; NaN: unknown.
using WorkForecast = std::vector<std::pair<double, double>>;

/**
 * How long the rest of a run will take: the work that its solver foresees,
 * times what an unknown update has cost lately.
 */
class RemainingTime
{
public:
  /// Counts a step.
  /// @param step_size simulated time [s]
  /// @param updates unknowns updated [-]
  /// @param cost time that the step took, output included [s]
  void add(double step_size, double updates, double cost);

  /// Takes what the solver foresees; empty: a second of simulated time goes
  /// on to cost what it has cost lately.
  void expect(WorkForecast forecast)
  {
    forecast_ = std::move(forecast);
  }

  /// Forgets what steps have cost, because another solver is at work; the
  /// forecast counts until the next one.
  void restart();

  /// Time that the run takes from @p time to @p end [s]; NaN if it is not
  /// known.
  double left(double time, double end) const;

private:
  WorkForecast forecast_;
  /// Sums over the steps, which fade.
  double time_ = 0.;    ///< simulated [s]
  double updates_ = 0.; ///< [-]
  double cost_ = 0.;    ///< [s]
};
} // namespace contrecoup

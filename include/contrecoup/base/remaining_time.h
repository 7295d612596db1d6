// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <utility>
#include <vector>

namespace contrecoup
{
/// Simulated times [s] and what a run is expected to cost until then, both
/// ascending, the latter in any unit.
using ExpectedCourse = std::vector<std::pair<double, double>>;

/// What the run costs until @p time; of a course that is not empty.
double cost_until(const ExpectedCourse &course, double time);

/**
 * Predicts how long a run goes on from what it has cost so far.
 *
 * What a second of simulated time costs changes by orders of magnitude while a
 * mesh follows a blast, from one dimension to three: nothing that has happened
 * tells what is to come. With a course, as trial runs on coarser meshes have
 * it, the cost still to come is that of the course, times the ratio between
 * what the run has cost so far and what was expected. Without one, it is what
 * the recent past cost for each second of simulated time.
 */
class RemainingTime
{
public:
  /// @param begin, end simulated times [s] between which the run goes
  /// @param course empty: unknown; costs in the unit of add() if they are to
  ///   count before the run has a past
  RemainingTime(double begin, double end, ExpectedCourse course = {});

  /// Notes that the run has come to @p time [s] and has cost so much so far;
  /// both ascend.
  void add(double time, double cost);

  /// What the rest will cost; infinite before anything is known.
  double left() const;

private:
  double end_;
  ExpectedCourse course_;
  std::vector<std::pair<double, double>> past_; ///< thinned out, begin first
};
} // namespace contrecoup

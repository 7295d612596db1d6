// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/run/remaining_time.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup
{
namespace
{
  /// Decay time of the cost of a step [s], longer than some field outputs.
  constexpr double decay_time = 30.;

  /// Work from @p begin to @p end. The first interval extends to earlier
  /// times, the last one to later times.
  double work_between(const WorkForecast &forecast,
                      const double begin,
                      const double end)
  {
    double work = 0., last = begin;
    for (const auto &[until, rate] : forecast)
      if (until > last)
      {
        const double next = std::min(until, end);
        work += rate * (next - last);
        last = next;
      }
    return work + forecast.back().second * (end - last);
  }
} // namespace

void RemainingTime::add(const double step_size,
                        const double updates,
                        const double cost)
{
  const double kept = std::exp(-cost / decay_time);
  time_ = kept * time_ + step_size;
  updates_ = kept * updates_ + updates;
  cost_ = kept * cost_ + cost;
}

void RemainingTime::restart()
{
  time_ = updates_ = cost_ = 0.;
}

double RemainingTime::left(const double time, const double end) const
{
  if (time >= end)
    return 0.;
  if (!(time_ > 0.) || !(updates_ > 0.))
    return std::numeric_limits<double>::quiet_NaN();
  return cost_ / updates_ *
         (forecast_.empty() ? updates_ / time_ * (end - time)
                            : work_between(forecast_, time, end));
}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/remaining_time.h>

#include <algorithm>
#include <limits>

namespace contrecoup
{
namespace
{
  /// The part of what a run has cost that is its recent past.
  constexpr double recent = 0.3;

  /// The part of the course that counts as spent as expected, so that the first
  /// steps do not scale it.
  constexpr double trust = 0.01;

  /// Values of the past beyond which every second one is forgotten.
  constexpr std::size_t most_values = 4000;
} // namespace


double cost_until(const ExpectedCourse &course, const double time)
{
  const auto after = std::lower_bound(
    course.begin(), course.end(), time, [](const auto &entry, const double t) {
      return entry.first < t;
    });
  if (after == course.end())
    return course.back().second;
  if (after == course.begin())
    return after->second;
  const auto before = after - 1;
  return before->second + (time - before->first) /
                            (after->first - before->first) *
                            (after->second - before->second);
}


RemainingTime::RemainingTime(const double begin,
                             const double end,
                             ExpectedCourse course)
  : end_(end)
  , course_(std::move(course))
  , past_{{begin, 0.}}
{
  if (course_.size() < 2 ||
      !(cost_until(course_, end) > cost_until(course_, begin)))
    course_.clear();
}


void RemainingTime::add(const double time, const double cost)
{
  past_.emplace_back(time, cost);
  if (past_.size() <= most_values)
    return;
  for (std::size_t i = 1; 2 * i < past_.size(); ++i)
    past_[i] = past_[2 * i];
  past_.resize(past_.size() / 2 + 1);
  past_.back() = {time, cost};
}


double RemainingTime::left() const
{
  const auto &[time, cost] = past_.back();
  if (time >= end_)
    return 0.;
  if (!course_.empty())
  {
    const double begin = cost_until(course_, past_.front().first);
    const double whole = cost_until(course_, end_) - begin;
    const double gone = cost_until(course_, time) - begin;
    return (cost + trust * whole) / (gone + trust * whole) * (whole - gone);
  }
  const auto begin =
    *(std::upper_bound(past_.begin(),
                       past_.end(),
                       (1. - recent) * cost,
                       [](const double limit, const auto &entry) {
                         return limit < entry.second;
                       }) -
      1);
  const double gone = time - begin.first;
  return gone > 0. ? (cost - begin.second) * (end_ - time) / gone
                   : std::numeric_limits<double>::infinity();
}
} // namespace contrecoup

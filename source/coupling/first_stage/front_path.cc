// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/first_stage/front_path.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::coupling
{
void FrontPath::add(const double time, const double distance)
{
  if (time > 0. && (jumps_.empty() || distance > jumps_.back().second))
    jumps_.emplace_back(time, distance);
}


double FrontPath::arrival(const double distance) const
{
  if (jumps_.size() < 2)
    return std::numeric_limits<double>::quiet_NaN();
  const auto [time, front] = jumps_.back();
  const auto half = std::lower_bound(
    jumps_.begin(), jumps_.end() - 2, std::make_pair(0.5 * time, 0.));
  const double exponent =
    std::log(front / half->second) / std::log(time / half->first);
  return time * std::pow(distance / front, 1. / std::clamp(exponent, 0.4, 1.));
}
} // namespace contrecoup::coupling

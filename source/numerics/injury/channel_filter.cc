// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/injury/channel_filter.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
namespace
{
  /// Periods of the class after which the filter has forgotten its beginning.
  constexpr double memory = 10.;

  /// One pass of the filter of second order, over values at rest before.
  void pass(std::vector<double> &values, const double corner)
  {
    const double root = std::sqrt(2.);
    const double scale = 1. + root * corner + corner * corner;
    const double a = corner * corner / scale;
    const double b1 = -2. * (corner * corner - 1.) / scale;
    const double b2 = (-1. + root * corner - corner * corner) / scale;
    double x1 = values[0], x2 = x1, y1 = x1, y2 = x1;
    for (double &value : values)
    {
      const double y = a * (value + 2. * x1 + x2) + b1 * y1 + b2 * y2;
      x2 = x1;
      x1 = value;
      y2 = y1;
      value = y1 = y;
    }
  }


  void check_history(const VectorHistory &history)
  {
    if (history.times.size() < 2)
      throw InputError("filter: " + std::to_string(history.times.size()) +
                       " times, at least 2 are needed");
    if (history.times.size() != history.values.size())
      throw InputError("filter: " + std::to_string(history.times.size()) +
                       " times, but " + std::to_string(history.values.size()) +
                       " values");
    for (std::size_t i = 1; i < history.times.size(); ++i)
      if (!(history.times[i] > history.times[i - 1]))
        throw InputError("filter: the times must increase");
  }
} // namespace


std::vector<double> channel_class_filter(const std::vector<double> &values,
                                         const double interval,
                                         const double channel_class)
{
  if (!(interval > 0.) || !(interval * channel_class < 0.2))
    throw InputError("filter: an interval of " + brief(interval) +
                     " s is too long for channel frequency class " +
                     brief(channel_class));
  if (values.empty())
    return {};
  const std::size_t n = values.size();
  const std::size_t padding = std::min(
    n - 1,
    static_cast<std::size_t>(std::ceil(memory / (channel_class * interval))));
  std::vector<double> longer;
  longer.reserve(n + 2 * padding);
  for (std::size_t i = padding; i > 0; --i)
    longer.push_back(2. * values.front() - values[i]);
  longer.insert(longer.end(), values.begin(), values.end());
  for (std::size_t i = 1; i <= padding; ++i)
    longer.push_back(2. * values.back() - values[n - 1 - i]);
  // The corner of the analogue filter, so that the digital one has it as well.
  const double corner = std::tan(M_PI * 2.0775 * channel_class * interval);
  for (unsigned int i = 0; i < 2; ++i)
  {
    pass(longer, corner);
    std::reverse(longer.begin(), longer.end());
  }
  return {longer.begin() + padding, longer.begin() + padding + n};
}


VectorHistory channel_class_filter(const VectorHistory &history,
                                   const double channel_class)
{
  check_history(history);
  const std::vector<double> &times = history.times;
  const double span = times.back() - times.front();
  const double longest = 0.1 / channel_class;
  // In a history over hours the filter would change nothing but the memory
  // that it takes.
  if (span > 1e7 * longest)
    return history;
  const std::size_t n = std::max(
    times.size(), static_cast<std::size_t>(std::ceil(span / longest)) + 1);
  const double interval = span / double(n - 1);
  VectorHistory result;
  std::array<std::vector<double>, 3> components;
  std::size_t after = 1;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double time = times.front() + double(i) * interval;
    while (after + 1 < times.size() && times[after] < time)
      ++after;
    const double part = std::clamp(
      (time - times[after - 1]) / (times[after] - times[after - 1]), 0., 1.);
    for (unsigned int d = 0; d < 3; ++d)
      components[d].push_back((1. - part) * history.values[after - 1][d] +
                              part * history.values[after][d]);
    result.times.push_back(time);
  }
  for (std::vector<double> &component : components)
    component = channel_class_filter(component, interval, channel_class);
  for (std::size_t i = 0; i < n; ++i)
    result.values.push_back(
      {{components[0][i], components[1][i], components[2][i]}});
  return result;
}
} // namespace contrecoup

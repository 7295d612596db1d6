// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/injury/head_injury.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace contrecoup
{
namespace
{
  const double gravity = 9.80665; // m/s^2

  void check_sample(const std::vector<double> &values,
                    const std::vector<double> &weights)
  {
    if (values.empty() || values.size() != weights.size())
      throw InputError(
        "weighted sample: " + std::to_string(values.size()) + " values and " +
        std::to_string(weights.size()) +
        " weights; as many of both are needed, and one at least");
  }


  void check_times(const std::vector<double> &times,
                   const std::size_t n_values,
                   const std::string &what)
  {
    if (times.size() != n_values || times.size() < 2)
      throw InputError(
        "head injury criterion: " + std::to_string(times.size()) +
        " times and " + std::to_string(n_values) + " " + what +
        "; as many of both are needed, and two at least");
    for (std::size_t i = 1; i < times.size(); ++i)
      if (!(times[i] > times[i - 1]))
        throw InputError("head injury criterion: the times must increase");
  }


  /// Integrals from the first time to each time [m/s].
  std::vector<double> integrals(const std::vector<double> &times,
                                const std::vector<double> &values)
  {
    check_times(times, values.size(), "accelerations");
    std::vector<double> result(1, 0.);
    for (std::size_t i = 1; i < times.size(); ++i)
      result.push_back(result.back() + 0.5 * (values[i] + values[i - 1]) *
                                         (times[i] - times[i - 1]));
    return result;
  }


  /// HIC from the speed gained until each time [m/s].
  HeadInjuryCriterion head_criterion_of(const std::vector<double> &times,
                                        const std::vector<double> &speed,
                                        const double longest)
  {
    HeadInjuryCriterion result;
    for (std::size_t i = 0; i < times.size(); ++i)
      for (std::size_t j = i + 1; j < times.size(); ++j)
      {
        const double duration = times[j] - times[i];
        // Round-off of times must not exclude the longest interval.
        if (duration > longest * (1. + 1e-9))
          break;
        const double mean =
          std::max(0., (speed[j] - speed[i]) / (duration * gravity));
        const double value = duration * std::pow(mean, 2.5);
        if (value > result.value)
          result = {value, times[i], times[j]};
      }
    return result;
  }
} // namespace


HeadInjuryCriterion
head_injury_criterion(const std::vector<double> &times,
                      const std::vector<double> &accelerations,
                      const double longest)
{
  return head_criterion_of(times, integrals(times, accelerations), longest);
}


HeadInjuryCriterion
head_injury_criterion(const std::vector<double> &times,
                      const std::vector<std::array<double, 3>> &velocities,
                      const double longest)
{
  check_times(times, velocities.size(), "velocities");
  std::vector<double> speed(1, 0.);
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    double square = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      square += std::pow(velocities[i][d] - velocities[i - 1][d], 2);
    speed.push_back(speed.back() + std::sqrt(square));
  }
  return head_criterion_of(times, speed, longest);
}


double brain_injury_criterion(const std::array<double, 3> &angular_velocities)
{
  const std::array<double, 3> critical = {{66.25, 56.45, 42.87}};
  double square = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    square += std::pow(angular_velocities[d] / critical[d], 2);
  return std::sqrt(square);
}


double weighted_percentile(const std::vector<double> &values,
                           const std::vector<double> &weights,
                           const double part)
{
  check_sample(values, weights);
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(
    order.begin(), order.end(), [&](const std::size_t i, const std::size_t j) {
      return values[i] < values[j];
    });
  const double wanted =
    part * std::accumulate(weights.begin(), weights.end(), 0.);
  double sum = 0.;
  for (const std::size_t i : order)
  {
    sum += weights[i];
    if (sum >= wanted * (1. - 1e-12))
      return values[i];
  }
  return values[order.back()];
}
} // namespace contrecoup

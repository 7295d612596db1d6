// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/study/pareto.h>

#include <cmath>

namespace contrecoup::study
{
std::vector<bool> pareto_front(const std::vector<double> &costs,
                               const std::vector<double> &errors)
{
  const auto counts = [&](const std::size_t i) {
    return std::isfinite(costs[i]) && std::isfinite(errors[i]);
  };
  const auto beats = [&](const std::size_t i, const std::size_t j) {
    return counts(i) && costs[i] <= costs[j] && errors[i] <= errors[j] &&
           (costs[i] < costs[j] || errors[i] < errors[j]);
  };
  std::vector<bool> on_front(costs.size());
  for (std::size_t i = 0; i < costs.size(); ++i)
  {
    bool beaten = !counts(i);
    for (std::size_t j = 0; j < costs.size(); ++j)
      beaten = beaten || beats(j, i);
    on_front[i] = !beaten;
  }
  return on_front;
}

std::optional<std::size_t> cheapest(const std::vector<double> &costs,
                                    const std::vector<double> &errors,
                                    const double required_error)
{
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < costs.size(); ++i)
    if (std::isfinite(costs[i]) && errors[i] <= required_error &&
        (!best || costs[i] < costs[*best]))
      best = i;
  return best;
}
} // namespace contrecoup::study

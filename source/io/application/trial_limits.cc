// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/application/trial_limits.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Largest number of coarsenings of a trial.
    constexpr unsigned int most_levels = 10;
  } // namespace

  std::optional<std::pair<int, int>> trial_levels()
  {
    const char *text = std::getenv(trial_levels_variable);
    if (text == nullptr)
      return std::nullopt;
    std::istringstream stream(text);
    std::pair<int, int> levels;
    if (!(stream >> levels.first >> levels.second) || levels.second < 0 ||
        levels.first < levels.second ||
        levels.first > static_cast<int>(most_levels))
      throw InputError(std::string(trial_levels_variable) + " = \"" +
                       std::string(text) +
                       "\": two levels are needed, the first from " +
                       std::to_string(most_levels) + " to the last, 0");
    return levels;
  }

  double trial_seconds()
  {
    const char *text = std::getenv("CONTRECOUP_CHECK_SECONDS");
    return text ? std::strtod(text, nullptr) : 4.;
  }

  unsigned int first_trial_levels(const CostEstimate &rough,
                                  const double budget)
  {
    unsigned int levels = 0;
    double seconds = rough.seconds;
    while (seconds > 0.005 * budget && levels < most_levels)
    {
      seconds /= 8.;
      ++levels;
    }
    return levels > 0 ? std::min(levels + 2, most_levels) : 0;
  }
} // namespace io
} // namespace contrecoup

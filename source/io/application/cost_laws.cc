// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/io/application/cost_laws.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
namespace io
{
  double extrapolate(const double before,
                     const double last,
                     const unsigned int levels,
                     const double low,
                     const double high,
                     const unsigned int gap)
  {
    if (!(before > 0.))
      return last * std::pow(2., 0.5 * (low + high) * levels);
    const double rate = std::log2(std::max(1., last / before)) / gap;
    if (rate <= low || rate >= high)
      return last * std::pow(2., std::min(rate, high) * levels);
    const double slow = std::pow(2., low * gap),
                 fast = std::pow(2., high * gap);
    const double b = (last - slow * before) / (fast - slow);
    const double a = before - b;
    return a * std::pow(2., low * (levels + gap)) +
           b * std::pow(2., high * (levels + gap));
  }

  double extrapolate_cells(const double before,
                           const double last,
                           const unsigned int levels,
                           const unsigned int dimension,
                           const unsigned int gap)
  {
    const double usual = 0.75 * dimension;
    // With growth alone where the trials say nothing.
    return before > 0. ? extrapolate(before, last, levels, 0., usual, gap)
                       : last * std::pow(2., usual * levels);
  }

  double extrapolate_to_limit(const double before,
                              const double last,
                              const unsigned int levels,
                              const unsigned int gap)
  {
    const double shrinkage = std::pow(2., -static_cast<double>(gap));
    const double rest = 1. - std::pow(2., -static_cast<double>(levels));
    return last + (last - before) * shrinkage / (1. - shrinkage) * rest;
  }

  Powers powers_of_steps(const double first,
                         const double middle,
                         const double last,
                         const unsigned int gap_before,
                         const unsigned int gap)
  {
    constexpr double converging_shock = 1.4;
    if (!(first > 0.) || !(middle > 0.))
      return {};
    // The first trial may be of a mesh that shows nothing yet.
    const double agreed = std::min(std::log2(middle / first) / gap_before,
                                   std::log2(last / middle) / gap);
    return agreed > 1. ? Powers{1., std::max(agreed, converging_shock)}
                       : Powers{};
  }

  double grow_with_cells(const double cells_before,
                         const double before,
                         const double cells_last,
                         const double last,
                         const double cells,
                         const double least_power)
  {
    const double whole = last * cells / cells_last;
    if (!(before > 0.) || !(cells_last > cells_before))
      return whole;
    const double slope = (last - before) / (cells_last - cells_before);
    const double least = last * std::pow(cells / cells_last, least_power);
    return std::clamp(last + slope * (cells - cells_last),
                      std::min(least, whole),
                      std::max(least, whole));
  }
} // namespace io
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace contrecoup::study
{
/**
 * Which settings no other one beats: none is as good in both cost and error
 * and better in one of them. A cost or error that is not finite never wins.
 */
std::vector<bool> pareto_front(const std::vector<double> &costs,
                               const std::vector<double> &errors);

/// The cheapest setting with an error of at most @p wanted; none if no
/// setting is so good.
std::optional<std::size_t> cheapest(const std::vector<double> &costs,
                                    const std::vector<double> &errors,
                                    double wanted);
} // namespace contrecoup::study

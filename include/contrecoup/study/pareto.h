// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace contrecoup::study
{
/// Pareto front: settings that no other setting dominates in cost and error.
/// Values that are not finite are never on the front.
std::vector<bool> pareto_front(const std::vector<double> &costs,
                               const std::vector<double> &errors);

/// The cheapest setting with an error of at most @p required_error; none if
/// there is none.
std::optional<std::size_t> cheapest(const std::vector<double> &costs,
                                    const std::vector<double> &errors,
                                    double required_error);
} // namespace contrecoup::study

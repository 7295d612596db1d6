// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>

#include <string>
#include <vector>

namespace contrecoup::ale
{
/// Findings of a run, in at most four lines for the screen: impact and
/// contact, pressures in the brain, strain and criterion.
/// @param results of the run, as in the summary
/// @param has_planes whether there are rigid planes
/// @param pressures which ones of the brain are meant, in words
std::vector<std::string> answer_lines(const std::vector<NamedValue> &results,
                                      const bool has_planes,
                                      const std::string &pressures);
} // namespace contrecoup::ale

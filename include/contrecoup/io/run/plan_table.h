// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Lines about the assumptions of a run: decision, estimate, limit, and the
  /// entry that changes the decision; then a warning for each estimate beyond
  /// its limit. Empty without assumptions.
  std::vector<std::string> plan_lines(const std::vector<Assumption> &plan);

  /// The same after the run, with measurements next to estimates, and a warning
  /// for each measurement beyond its limit.
  std::vector<std::string> audit_lines(const std::vector<Assumption> &plan,
                                       const std::vector<Assumption> &audit);

  /// Replaces in @p warnings, without "WARNING: ", those of estimates that the
  /// run has measured otherwise: by the warning of the measurement, or, where
  /// that holds, by nothing, which the log says. For finished runs.
  void replace_estimates(const std::vector<Assumption> &plan,
                         const std::vector<Assumption> &audit,
                         std::vector<std::string> &warnings);

  /// Sums for runs one after the other, and the largest memory. Time and output
  /// are 0, which is unknown, where those of a run are.
  CostEstimate
  total_of(const std::vector<std::pair<std::string, CostEstimate>> &costs);

  /// A table of what runs are expected to cost, with a heading, a row for each,
  /// and one for all of them, one after the other, if there are several. What
  /// is 0 or not a number is unknown, and blank: lines say why.
  std::vector<std::string>
  cost_lines(const std::vector<std::pair<std::string, CostEstimate>> &costs);

  /// "1 rank", "2 ranks": those for which costs are told.
  std::string counted_ranks(unsigned int number);

  /// The assumption with this name, or nullptr.
  const Assumption *find_assumption(const std::vector<Assumption> &items,
                                    const std::string &name);

  /// Whether an item of the audit keeps its limit: by what was measured, else a
  /// planned figure beyond the limit breaks it; nothing where neither says.
  std::optional<bool> holds(const Assumption &audited,
                            const Assumption *planned);
} // namespace io
} // namespace contrecoup

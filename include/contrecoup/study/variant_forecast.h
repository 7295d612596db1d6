// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/application/check_file.h>
#include <contrecoup/study/variant_runner.h>

#include <string>
#include <vector>

namespace contrecoup::study
{
/// Report of --check on a variant.
struct VariantForecast
{
  std::string refusal;               ///< one line; empty: accepted
  std::string text;                  ///< output of --check
  std::vector<std::string> warnings; ///< in this output
  io::CheckReport report;
};

/**
 * Asks the application for a forecast of each task, several at once within a
 * number of cores. With many tasks, each gets less time for trial runs, so that
 * all take about a minute.
 * @param count number of the first tasks that are asked for
 * @param with_trials whether costs are predicted by trial runs; without them
 * they are rough
 * @throws SystemError when the machine failed, Stopped after a signal
 */
std::vector<VariantForecast>
forecast_variants(const ApplicationUnderStudy &application,
                  const std::vector<Task> &tasks,
                  std::size_t count,
                  unsigned int cores,
                  bool with_trials);

/// Sum of the forecasts of runs that are made @p slots at once, in their
/// order: cells, unknowns and memory are those of the largest run. A figure
/// that is 0, unknown, for an accepted one is 0 in the sum.
CostEstimate sum_of(const std::vector<VariantForecast> &forecasts,
                    std::size_t slots);

/// Whether a run with these outputs, see io::CheckReport, can have one at @p
/// address; "*" stands for any letters in both.
bool can_have(const std::vector<std::string> &outputs,
              const std::string &address);

/// Suggestion for an address that no output matches; starts with "; " unless
/// empty.
std::string suggest_output(const std::vector<std::string> &outputs,
                           const std::string &address);
} // namespace contrecoup::study

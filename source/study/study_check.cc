// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/run/plan_table.h>
#include <contrecoup/study/report.h>
#include <contrecoup/study/study.h>
#include <contrecoup/study/study_result.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace contrecoup::study
{
namespace
{
  /// Refused variants that are named on the screen.
  constexpr std::size_t most_refusals = 5;
  /// Warnings of the runs' plans that are shown.
  constexpr std::size_t most_warnings = 5;

  /// Whether trial runs, and with them forecasts, are wanted.
  bool wants_forecasts()
  {
    const char *text = std::getenv("CONTRECOUP_CHECK_SECONDS");
    return text == nullptr || std::strtod(text, nullptr) > 0.;
  }

  std::string from_to(const double least, const double most)
  {
    return brief(std::round(least), 7) +
           (most > least ? " to " + brief(std::round(most), 7) : "");
  }

  /// A figure in words; unknown if it is 0, as without trial runs.
  std::string told(const double value, const std::string &words)
  {
    return value > 0. ? "about " + words : "unknown without trial runs";
  }
} // namespace

void Study::require_possible_outputs(
  const std::vector<VariantForecast> &forecasts) const
{
  std::vector<std::string> outputs;
  for (const VariantForecast &forecast : forecasts)
    outputs.insert(outputs.end(),
                   forecast.report.outputs.begin(),
                   forecast.report.outputs.end());
  // A refused variant, or a program of another kind, says nothing of outputs.
  if (outputs.empty())
    return;
  const auto require = [&](const std::string &address,
                           const std::string &where,
                           const std::string &advice) {
    if (!can_have(outputs, address))
      throw InputError(where + ": a run of " + application_.name() +
                       " has no output \"" + address + "\"" + advice);
  };
  const bool all_asked = forecasts.size() == tasks_.size();
  for (const ColumnRequest &column : parameters_.columns)
    if (all_asked || !column.may_be_missing)
      require(column.address,
              "Study/Columns",
              suggest_output(outputs, column.address));
  const std::string of_error = parameters_.error.address();
  if (!of_error.empty())
    require(of_error,
            "Error/Name",
            "; Error/Kind = none makes tables and curves of Study/Columns "
            "without errors");
}

void Study::require_accepted(
  const std::vector<VariantForecast> &forecasts) const
{
  std::size_t n_refused = 0;
  std::string first;
  for (std::size_t i = 0; i < forecasts.size(); ++i)
  {
    if (forecasts[i].refusal.empty())
      continue;
    const std::string line =
      "the run (" + task_label(tasks_[i]) + "): " + forecasts[i].refusal;
    if (++n_refused == 1)
      first = line;
    if (n_refused <= most_refusals)
      show_line("would be refused: " + line);
  }
  const bool is_result =
    parameters_.mode == "stability map" && n_refused < forecasts.size();
  if (n_refused > 0 && !is_result)
    throw InputError((forecasts.size() == 1
                        ? ""
                        : std::to_string(n_refused) + " of " +
                            std::to_string(forecasts.size()) +
                            " variants would be refused; ") +
                     first);
}

void Study::print_costs(const std::vector<VariantForecast> &forecasts) const
{
  double least_cells = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < forecasts.size(); ++i)
  {
    const CostEstimate &cost = forecasts[i].report.cost;
    least_cells = std::min(least_cells, cost.cells);
    log_line("  " + task_label(tasks_[i]) + ": cells " +
             told(cost.cells, brief(std::round(cost.cells), 7)) + ", steps " +
             told(cost.steps, brief(cost.steps, 3)) + ", memory " +
             told(cost.memory, bytes(cost.memory)) + ", time " +
             told(cost.seconds, duration(cost.seconds)) + ", output " +
             told(cost.output, bytes(cost.output)));
  }
  const std::size_t slots = std::min<std::size_t>(
    std::max(1U, parameters_.cores / parameters_.ranks), tasks_.size());
  CostEstimate sum = sum_of(forecasts, slots);
  if (sum.output > 0.)
    sum.output += size_of_own_files();
  io::write_check_file({"study", sum, {}});
  show_line("all runs, " + std::to_string(slots) + " at once:");
  show_line("  cells     " +
            (sum.cells > 0. ? from_to(least_cells, sum.cells) : told(0., "")));
  // A run without steps, as of anatomy, has a known time.
  if (sum.steps > 0. || !(sum.seconds > 0.))
    show_line("  steps     " +
              told(sum.steps, brief(sum.steps, 3) + " in all"));
  const double at_once = static_cast<double>(slots) * sum.memory;
  show_line("  memory    " + told(sum.memory,
                                  bytes(sum.memory) + " for the largest run" +
                                    (slots > 1 ? ", up to " + bytes(at_once) +
                                                   " for those at once"
                                               : "")));
  show_line("  wall time " + told(sum.seconds, duration(sum.seconds)));
  show_line("  output    " + told(sum.output, bytes(sum.output)) + " in " +
            folder_);
}

double Study::size_of_own_files() const
{
  // Each outcome names all entries, as does the recommendation.
  double entries = 0.;
  for (const auto &[entry, value] : application_.entries({}).values)
    entries += static_cast<double>(entry.size() + value.size() + 12);
  constexpr double pictures = 1.8e5, tables = 2e4;
  return pictures + tables +
         (static_cast<double>(tasks_.size()) + 1.) * entries;
}

void Study::check() const
{
  const bool with_trials = wants_forecasts();
  const std::size_t n_asked = with_trials ? tasks_.size() : 1;
  const auto forecasts = forecast_variants(
    application_, tasks_, n_asked, parameters_.cores, with_trials);
  show_line("study would run " + std::to_string(tasks_.size()) + " times " +
            application_.name() + " on " + parameters_.parameter_file +
            ", each on " + io::counted_ranks(parameters_.ranks) + ":");
  for (const Factor &factor : parameters_.factors)
    show_line("  " + factor.name + ": " +
              (factor.is_range
                 ? brief(factor.lower) + " to " + brief(factor.upper)
                 : join(factor.labels, "; ")));
  require_possible_outputs(forecasts);
  require_accepted(forecasts);
  StudyResult sizes;
  // The reference is none of the variants.
  for (std::size_t i = has_reference_ ? 1 : 0; i < forecasts.size(); ++i)
    if (const double cells = forecasts[i].report.cost.cells; cells > 0.)
    {
      sizes.rows.emplace_back();
      sizes.rows.back().variant = tasks_[i].variant;
      sizes.rows.back().record.unknowns = cells;
    }
  for (const std::string &warning : place_rows(parameters_.factors, sizes))
    show_line(warning);
  WarningsByRun warnings;
  for (std::size_t i = 0; i < forecasts.size(); ++i)
    warnings.emplace_back(task_label(tasks_[i]), forecasts[i].warnings);
  for (const std::string &warning : told_warnings(warnings, most_warnings))
    show_line("WARNING: " + warning);
  if (n_asked == tasks_.size())
    print_costs(forecasts);
  else
    show_line("  output " + folder_);
  log_line("The first run:");
  log_line(forecasts.front().text);
}
} // namespace contrecoup::study

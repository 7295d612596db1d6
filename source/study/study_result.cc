// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/study/convergence.h>
#include <contrecoup/study/pareto.h>
#include <contrecoup/study/study_result.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace contrecoup::study
{
namespace
{
  double cost_of(const RunRecord &record, const std::string &cost)
  {
    return cost == "core seconds"   ? record.core_seconds
           : cost == "wall seconds" ? record.wall_seconds
           : cost == "updates"      ? record.updates
                                    : record.memory;
  }

  /// Index of the factor that refines the mesh; number of factors if none.
  std::size_t refining_factor(const std::vector<Factor> &factors)
  {
    std::size_t i = 0;
    while (i < factors.size() && factors[i].refinement == Refinement::none)
      ++i;
    return i;
  }

  /// Sets mesh width and series of a row.
  void place(const std::vector<Factor> &factors,
             ResultRow &row,
             std::vector<std::string> &series)
  {
    const std::size_t refining = refining_factor(factors);
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < factors.size(); ++i)
      if (i != refining)
        labels.push_back(row.variant.labels[i]);
    const std::string label = join(labels, ", ");
    const auto found = std::find(series.begin(), series.end(), label);
    row.series = static_cast<std::size_t>(found - series.begin());
    if (found == series.end())
      series.push_back(label);
    if (refining == factors.size())
      return;
    const double number = row.variant.numbers[refining];
    const Refinement refinement = factors[refining].refinement;
    row.width = refinement == Refinement::by_level   ? std::exp2(-number)
                : refinement == Refinement::by_count ? 1. / number
                                                     : number;
  }

  /// Rows of a series with an error, from coarse to fine.
  std::vector<ResultRow *> rows_of(const std::size_t series,
                                   std::vector<ResultRow> &rows)
  {
    std::vector<ResultRow *> found;
    for (ResultRow &row : rows)
      if (row.series == series && std::isfinite(row.error) &&
          std::isfinite(row.width))
        found.push_back(&row);
    std::stable_sort(found.begin(), found.end(), [](auto *a, auto *b) {
      return a->width > b->width;
    });
    return found;
  }

  /// Contradiction to a series whose meshes are finer the smaller their width
  /// is: the finest has fewer unknowns than the coarsest. Empty: none.
  std::string contradiction(const Factor &factor,
                            const std::size_t series,
                            const std::vector<ResultRow> &rows)
  {
    const ResultRow *coarsest = nullptr, *finest = nullptr;
    for (const ResultRow &row : rows)
      if (row.series == series && std::isfinite(row.width) &&
          std::isfinite(row.record.unknowns))
      {
        if (coarsest == nullptr || row.width > coarsest->width)
          coarsest = &row;
        if (finest == nullptr || row.width < finest->width)
          finest = &row;
      }
    if (finest == nullptr ||
        !(finest->record.unknowns < coarsest->record.unknowns))
      return "";
    const auto words = [&](const ResultRow &row) {
      return brief(row.record.unknowns, 7) +
             " unknowns (or cells) with width " + brief(row.width, 3);
    };
    return "WARNING: Vary " + factor.name +
           "/Refinement: what it calls the finest mesh has " + words(*finest) +
           ", the coarsest " + words(*coarsest) +
           "; orders and extrapolations are left out. A number of cells refines "
           "by count, the edge of a cell by size";
  }

  /// Replaces quantities by their distance from the extrapolated limit.
  void extrapolate_series(const std::size_t series, StudyResult &result)
  {
    const std::string name =
      result.series[series].empty() ? "" : result.series[series] + ": ";
    const auto rows = rows_of(series, result.rows);
    if (rows.size() < 3)
    {
      for (ResultRow *row : rows)
        row->error = ResultRow::unknown;
      result.remarks.push_back(name + "fewer than three meshes were finished, "
                                      "too few for an extrapolation.");
      return;
    }
    std::vector<double> widths, values;
    for (const ResultRow *row : rows)
    {
      widths.push_back(row->width);
      values.push_back(row->error);
    }
    const Extrapolation found = extrapolate(widths, values);
    const double scale = found.limit == 0. ? 1. : std::abs(found.limit);
    for (ResultRow *row : rows)
      row->error = std::abs(row->error - found.limit) / scale;
    if (found.is_asymptotic)
    {
      result.remarks.push_back(name + "tends to " + brief(found.limit, 7) +
                               " with order " + brief(found.order, 3) +
                               " on the three finest meshes.");
      return;
    }
    // The limit equals the finest value; compare with the next coarser mesh.
    const std::size_t n = values.size();
    rows.back()->error = std::abs(values[n - 1] - values[n - 2]) / scale;
    result.remarks.push_back(name +
                             "does not yet converge steadily; errors are "
                             "differences from the finest mesh, " +
                             brief(found.limit, 7) + ".");
  }

  void find_orders(const std::size_t series, StudyResult &result)
  {
    const auto rows = rows_of(series, result.rows);
    for (std::size_t i = 1; i < rows.size(); ++i)
      rows[i]->order = observed_order(
        rows[i - 1]->error, rows[i]->error, rows[i - 1]->width, rows[i]->width);
  }

  void find_front(const double required_error, StudyResult &result)
  {
    std::vector<double> costs, errors;
    for (const ResultRow &row : result.rows)
    {
      costs.push_back(row.cost);
      errors.push_back(row.error);
    }
    const std::vector<bool> front = pareto_front(costs, errors);
    for (std::size_t i = 0; i < front.size(); ++i)
      result.rows[i].on_front = front[i];
    if (required_error > 0.)
      result.recommended = cheapest(costs, errors, required_error);
  }

  /// Summary of a run; null if it cannot be read.
  nlohmann::json read_summary(const std::string &folder)
  {
    const nlohmann::json summary =
      io::read_json(folder + "/summary.json", io::formats::summary);
    return summary.is_object() ? summary : nlohmann::json();
  }

  std::vector<double> values_of(const std::vector<Column> &columns,
                                const RunOutputs &outputs)
  {
    const auto &names = outputs.names();
    std::vector<double> values;
    for (const Column &column : columns)
      values.push_back(std::find(names.begin(), names.end(), column.address) ==
                           names.end()
                         ? ResultRow::unknown
                         : outputs.at(column.address).value);
    return values;
  }

  /// Columns of which a run has lower limits.
  std::vector<bool> lower_limits_of(const std::vector<Column> &columns,
                                    const RunOutputs &outputs)
  {
    const auto &names = outputs.names();
    std::vector<bool> limits;
    for (const Column &column : columns)
      limits.push_back(std::find(names.begin(), names.end(), column.address) !=
                         names.end() &&
                       outputs.at(column.address).is_lower_limit);
    return limits;
  }

  ResultRow make_row(const StudyParameters &parameters, const Task &task)
  {
    ResultRow row;
    row.variant = task.variant;
    row.outcome = *task.outcome;
    row.folder = task.run_folder();
    if (!row.outcome.is_usable())
      return row;
    row.record = read_record(row.folder);
    row.cost = cost_of(row.record, parameters.cost);
    if (!parameters.error.is_active())
      return row;
    row.error = parameters.error.value(row.folder, read_summary(row.folder));
    if (!std::isfinite(row.error))
    {
      row.outcome.kind = "unstable";
      row.outcome.reason = "its error is not a finite number";
    }
    return row;
  }

  /// Finds the further columns and their values in all finished runs.
  void read_columns(const StudyParameters &parameters, StudyResult &result)
  {
    if (parameters.columns.empty())
      return;
    std::map<const ResultRow *, RunOutputs> outputs;
    std::vector<const RunOutputs *> runs;
    for (const ResultRow &row : result.rows)
      if (row.outcome.is_usable())
        runs.push_back(
          &outputs.emplace(&row, RunOutputs(row.folder)).first->second);
    const std::string &folder = parameters.error.reference_folder();
    std::optional<RunOutputs> reference;
    if (!folder.empty())
      runs.push_back(&reference.emplace(folder));
    std::vector<std::string> factors;
    for (const Factor &factor : parameters.factors)
      factors.push_back(factor.name);
    result.columns = find_columns(parameters.columns, runs, factors);
    for (ResultRow &row : result.rows)
      if (const auto found = outputs.find(&row); found != outputs.end())
      {
        row.columns = values_of(result.columns, found->second);
        row.lower_limits = lower_limits_of(result.columns, found->second);
      }
    if (reference)
      result.reference_columns = values_of(result.columns, *reference);
  }
} // namespace

std::vector<std::string> place_rows(const std::vector<Factor> &factors,
                                    StudyResult &result)
{
  for (ResultRow &row : result.rows)
    place(factors, row, result.series);
  const std::size_t refining = refining_factor(factors);
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < result.series.size(); ++i)
  {
    const std::string words =
      refining == factors.size()
        ? ""
        : contradiction(factors[refining], i, result.rows);
    if (words.empty())
      continue;
    for (ResultRow &row : result.rows)
      if (row.series == i)
        row.width = ResultRow::unknown;
    warnings.push_back(words);
  }
  return warnings;
}

std::size_t StudyResult::n_unfinished() const
{
  return static_cast<std::size_t>(
    std::count_if(rows.begin(), rows.end(), [](const ResultRow &row) {
      return !row.outcome.is_usable();
    }));
}

std::size_t StudyResult::n_cut_off() const
{
  return static_cast<std::size_t>(
    std::count_if(rows.begin(), rows.end(), [](const ResultRow &row) {
      return std::count(
               row.lower_limits.begin(), row.lower_limits.end(), true) > 0;
    }));
}

std::size_t StudyResult::n_warned() const
{
  return static_cast<std::size_t>(
    std::count_if(rows.begin(), rows.end(), [](const ResultRow &row) {
      return !row.record.warnings.empty();
    }));
}

std::vector<std::string> StudyResult::empty_columns() const
{
  std::vector<std::string> titles;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (std::none_of(rows.begin(), rows.end(), [&](const ResultRow &row) {
          return i < row.columns.size() && !std::isnan(row.columns[i]);
        }))
      titles.push_back(columns[i].title);
  return titles;
}

StudyResult evaluate(const StudyParameters &parameters,
                     const std::vector<Task> &tasks)
{
  StudyResult result;
  for (const Task &task : tasks)
    if (task.outcome)
      result.rows.push_back(make_row(parameters, task));
  result.remarks = place_rows(parameters.factors, result);
  if (parameters.error.is_self_convergence())
    for (ResultRow &row : result.rows)
      if (!std::isfinite(row.width))
        row.error = ResultRow::unknown;
  const bool has_widths = result.remarks.empty();
  for (std::size_t i = 0; i < result.series.size(); ++i)
  {
    if (parameters.error.is_self_convergence() && has_widths)
      extrapolate_series(i, result);
    find_orders(i, result);
  }
  find_front(parameters.error.required_error(), result);
  read_columns(parameters, result);
  if (!parameters.error.reference_folder().empty())
    result.reference_warnings =
      read_record(parameters.error.reference_folder()).warnings;
  return result;
}
} // namespace contrecoup::study

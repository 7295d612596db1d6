// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/run/plan_table.h>
#include <contrecoup/study/report.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

namespace contrecoup::study
{
namespace
{
  std::string csv_number(const double value)
  {
    return std::isfinite(value) ? exact(value) : "";
  }

  std::string quoted(const std::string &text)
  {
    std::string result = "\"";
    for (const char letter : text)
      result += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return result + "\"";
  }

  io::Json json_number(const double value)
  {
    return std::isfinite(value) ? io::Json(value) : io::Json(nullptr);
  }

  io::Json json_numbers(const std::vector<double> &values)
  {
    io::Json numbers = io::Json::array();
    for (const double value : values)
      numbers.push_back(json_number(value));
    return numbers;
  }

  std::string number_text(const double value, const int digits = 3)
  {
    return std::isfinite(value) ? brief(value, digits) : "";
  }

  /// Cost in the unit of its column.
  std::string cost_text(const std::string &cost, const double value)
  {
    return !std::isfinite(value) ? ""
           : cost == "memory"    ? bytes(value)
                                 : brief(value, 3);
  }

  std::string cost_title(const std::string &cost)
  {
    return cost == "core seconds"   ? "core seconds"
           : cost == "wall seconds" ? "wall seconds"
           : cost == "updates"      ? "updates"
                                    : "peak memory";
  }

  std::string cell(std::string text)
  {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos;
         at += 2)
      text.replace(at, 1, "\\|");
    return text;
  }

  /// Writes the titles of the factors; returns the beginning of the rule
  /// below.
  std::string begin_table(const StudyParameters &parameters, std::ostream &out)
  {
    std::string rule = "|";
    out << '|';
    for (const Factor &factor : parameters.factors)
    {
      out << ' ' << cell(factor.name) << " |";
      rule += "---|";
    }
    return rule;
  }

  std::string markdown_table(const StudyParameters &parameters,
                             const StudyResult &result)
  {
    std::ostringstream out;
    const bool has_errors = parameters.error.is_active();
    const std::string rule = begin_table(parameters, out);
    out << " outcome | unknowns | steps | " << cost_title(parameters.cost)
        << " |";
    if (has_errors)
      out << ' ' << parameters.error.title(result.columns)
          << " | order | best |";
    out << '\n'
        << rule << "---|---:|---:|---:|"
        << (has_errors ? "---:|---:|:---:|" : "") << '\n';
    for (const ResultRow &row : result.rows)
    {
      out << '|';
      for (const std::string &label : row.variant.labels)
        out << ' ' << cell(label) << " |";
      out << ' ' << row.outcome.kind << " | "
          << number_text(row.record.unknowns, 9) << " | "
          << number_text(row.record.steps, 9) << " | "
          << cost_text(parameters.cost, row.cost) << " |";
      if (has_errors)
        out << ' ' << number_text(row.error) << " | " << number_text(row.order)
            << " | " << (row.on_front ? "*" : "") << " |";
      out << '\n';
    }
    return out.str();
  }

  /// Table of the further columns, with those of the reference run last. A run
  /// that did not finish has its outcome in place of numbers.
  std::string further_table(const StudyParameters &parameters,
                            const StudyResult &result)
  {
    std::ostringstream out;
    std::string rule = begin_table(parameters, out);
    for (const Column &column : result.columns)
    {
      out << ' ' << cell(title_with_unit(column)) << " |";
      rule += "---:|";
    }
    out << '\n' << rule << '\n';
    const auto add_row = [&](const std::vector<std::string> &labels,
                             const std::vector<double> &values,
                             const std::vector<bool> &limits,
                             const std::string &outcome) {
      out << '|';
      for (const std::string &label : labels)
        out << ' ' << cell(label) << " |";
      for (std::size_t i = 0; i < result.columns.size(); ++i)
        out << ' '
            << (i >= limits.size() || !limits[i] ? ""
                : values[i] < 0.                 ? "≤ "
                                                 : "≥ ")
            << (i >= values.size()         ? outcome
                : std::isfinite(values[i]) ? number_text(values[i], 4)
                                           : "unknown")
            << " |";
      out << '\n';
    };
    for (const ResultRow &row : result.rows)
      add_row(
        row.variant.labels, row.columns, row.lower_limits, row.outcome.kind);
    std::vector<std::string> labels(parameters.factors.size());
    if (!labels.empty())
      labels.front() = "reference run";
    if (!result.reference_columns.empty())
      add_row(labels, result.reference_columns, {}, "");
    return out.str();
  }

  /// Addresses of the columns of which a row has lower limits.
  std::vector<std::string> limits_of(const ResultRow &row,
                                     const StudyResult &result)
  {
    std::vector<std::string> addresses;
    for (std::size_t i = 0; i < row.lower_limits.size(); ++i)
      if (row.lower_limits[i])
        addresses.push_back(result.columns[i].address);
    return addresses;
  }

  /// List of runs that did not finish, with reasons.
  std::string failures(const StudyResult &result)
  {
    std::string text;
    for (const ResultRow &row : result.rows)
      if (!row.outcome.is_usable())
        text += "- " + join(row.variant.labels, ", ") + ": " +
                row.outcome.kind + ", " + one_line(row.outcome.reason) + "\n";
    return text;
  }
  /// List of the warnings of the runs, empty without any.
  std::string warnings_of(const StudyResult &result)
  {
    constexpr std::size_t most = 40;
    WarningsByRun runs = {{reference_name, result.reference_warnings}};
    for (const ResultRow &row : result.rows)
      runs.emplace_back(join(row.variant.labels, ", "), row.record.warnings);
    std::string text;
    for (const std::string &line : told_warnings(runs, most))
      text += "- " + line + "\n";
    return text;
  }
} // namespace

std::vector<std::string> told_warnings(const WarningsByRun &runs,
                                       const std::size_t most)
{
  std::vector<std::string> order;
  std::map<std::string, std::vector<std::string>> found;
  for (const auto &[run, warnings] : runs)
    for (const std::string &warning : warnings)
    {
      if (found.count(warning) == 0)
        order.push_back(warning);
      found[warning].push_back(run);
    }
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(most, order.size()); ++i)
    lines.push_back(join(found[order[i]], "; ") + ": " + one_line(order[i]));
  if (order.size() > most)
    lines.push_back("further warnings: " + std::to_string(order.size() - most));
  return lines;
}

std::string to_csv(const StudyParameters &parameters, const StudyResult &result)
{
  std::ostringstream out;
  for (const Factor &factor : parameters.factors)
    out << quoted(factor.name) << ',';
  out << "outcome,reason,exit code,cells,unknowns,steps,retries,"
         "wall [s],core [s],updates,memory [byte],error,order,"
         "pareto front,lower limits,";
  for (const Column &column : result.columns)
    out << quoted(column.address +
                  (column.unit.empty() ? "" : " [" + column.unit + "]"))
        << ',';
  out << "folder\n";
  for (const ResultRow &row : result.rows)
  {
    for (const std::string &label : row.variant.labels)
      out << quoted(label) << ',';
    out << row.outcome.kind << ',' << quoted(one_line(row.outcome.reason))
        << ',' << row.outcome.exit_code;
    const RunRecord &record = row.record;
    for (const double value : {record.cells,
                               record.unknowns,
                               record.steps,
                               record.retries,
                               record.wall_seconds,
                               record.core_seconds,
                               record.updates,
                               record.memory,
                               row.error,
                               row.order})
      out << ',' << csv_number(value);
    const bool has_errors = parameters.error.is_active();
    out << ','
        << (!has_errors    ? ""
            : row.on_front ? "yes"
                           : "no")
        << ',' << quoted(join(limits_of(row, result), "; ")) << ',';
    for (std::size_t i = 0; i < result.columns.size(); ++i)
      out << (i < row.columns.size() ? csv_number(row.columns[i]) : "") << ',';
    out << quoted(row.folder) << '\n';
  }
  return out.str();
}

std::string outputs_csv(const std::string &folder)
{
  const RunOutputs outputs(folder);
  std::ostringstream out;
  out << "output,value,unit\n";
  for (const std::string &address : outputs.names())
  {
    const RunOutput output = outputs.at(address);
    out << quoted(address) << ',' << csv_number(output.value) << ','
        << output.unit << '\n';
  }
  return out.str();
}

std::string to_markdown(const StudyParameters &parameters,
                        const StudyResult &result)
{
  std::ostringstream out;
  out << "# " << parameters.title << "\n\n`" << parameters.application
      << "` on `"
      << std::filesystem::path(parameters.parameter_file).filename().string()
      << "`, " << parameters.design.kind << ", " << result.rows.size()
      << " variants, " << io::counted_ranks(parameters.ranks) << " each. ";
  if (parameters.error.is_active())
    out << "Best: no other variant has both a smaller error and a smaller "
           "cost.";
  out << "\n\n" << markdown_table(parameters, result);
  if (!result.columns.empty())
    out << '\n' << further_table(parameters, result);
  if (std::any_of(
        result.rows.begin(), result.rows.end(), [](const ResultRow &row) {
          return row.outcome.kind == "retried";
        }))
    out << "\nretried: " << retried_in_words << ".\n";
  if (result.n_cut_off() > 0)
    out << "\n≥: a lower limit, ≤: one of the magnitude, as the run ends "
           "before a positive phase, a contact, a strain or a pressure does.\n";
  const std::string failed = failures(result);
  if (!failed.empty())
    out << "\nNot finished, " << result.n_unfinished() << " of "
        << result.rows.size() << ":\n\n"
        << failed;
  if (const std::string warnings = warnings_of(result); !warnings.empty())
    out << "\nWarnings of the runs:\n\n" << warnings;
  for (const std::string &remark : result.remarks)
    out << '\n' << remark << '\n';
  for (const std::string &line : recommendation(parameters, result))
    out << '\n' << line << '\n';
  return out.str();
}

std::string to_json(const StudyParameters &parameters,
                    const StudyResult &result)
{
  io::Json rows = io::Json::array(), factors = io::Json::array(),
           columns = io::Json::array();
  for (const Column &column : result.columns)
    columns.push_back({{"address", column.address},
                       {"title", column.title},
                       {"unit", column.unit}});
  for (const Factor &factor : parameters.factors)
    factors.push_back({{"name", factor.name},
                       {"unit", factor.unit},
                       {"labels", factor.labels},
                       {"refines", factor.refinement != Refinement::none}});
  for (const ResultRow &row : result.rows)
  {
    rows.push_back({{"labels", row.variant.labels},
                    {"numbers", json_numbers(row.variant.numbers)},
                    {"outcome", row.outcome.kind},
                    {"reason", row.outcome.reason},
                    {"series", row.series},
                    {"width", json_number(row.width)},
                    {"unknowns", json_number(row.record.unknowns)},
                    {"retries", json_number(row.record.retries)},
                    {"cost", json_number(row.cost)},
                    {"error", json_number(row.error)},
                    {"order", json_number(row.order)},
                    {"columns", json_numbers(row.columns)},
                    {"lower_limits", row.lower_limits},
                    {"front", row.on_front}});
  }
  const io::Json json = {
    {"format", io::formats::study.number},
    {"title", parameters.title},
    {"mode", parameters.mode},
    {"cost", parameters.cost},
    {"error",
     parameters.error.is_active()
       ? io::Json(parameters.error.title(result.columns))
       : io::Json(nullptr)},
    {"wanted", parameters.error.required_error()},
    {"factors", factors},
    {"columns", columns},
    {"reference_columns", json_numbers(result.reference_columns)},
    {"series", result.series},
    {"recommended",
     result.recommended ? io::Json(*result.recommended) : io::Json(nullptr)},
    {"rows", rows}};
  return json.dump(1, ' ', false, io::Json::error_handler_t::replace) + "\n";
}
} // namespace contrecoup::study

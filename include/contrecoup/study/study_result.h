// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/run_record.h>
#include <contrecoup/study/study_parameters.h>
#include <contrecoup/study/variant_runner.h>

namespace contrecoup::study
{
/// Name in messages of the run that errors are taken from.
constexpr const char *reference_name = "the reference run";

/// A row of the study's table.
struct ResultRow
{
  static constexpr double unknown = RunRecord::unknown;

  Variant variant;
  Outcome outcome;
  std::string folder;     ///< output folder of the run
  std::size_t series = 0; ///< rows of a series differ only in refinement
  double width = unknown; ///< relative mesh width [-]
  RunRecord record;       ///< sizes and costs
  double cost = unknown;  ///< the cost that the study uses
  double error = unknown;
  double order = unknown; ///< from the next coarser mesh of the series
  bool on_front = false;  ///< Pareto front of cost and error
  /// Values of StudyResult::columns; NaN where the run has none.
  std::vector<double> columns;
  /// Columns that are lower limits, as the run cuts a positive phase off.
  std::vector<bool> lower_limits;
};

/// Results of a study.
struct StudyResult
{
  std::vector<ResultRow> rows;
  std::vector<std::string> series; ///< labels of the series
  /// The recommended row.
  std::optional<std::size_t> recommended;
  std::vector<std::string> remarks; ///< remarks for the user
  std::vector<Column> columns;      ///< further columns
  /// ResultRow::columns of the reference run; empty without one.
  std::vector<double> reference_columns;
  /// Warnings of the run that errors are taken from; empty without one.
  std::vector<std::string> reference_warnings;

  /// Number of runs that did not finish.
  std::size_t n_unfinished() const;
  /// Number of runs of which a column is a lower limit.
  std::size_t n_cut_off() const;
  /// Number of runs with warnings, without the reference run.
  std::size_t n_warned() const;
  /// Titles of further columns that no run has.
  std::vector<std::string> empty_columns() const;
};

/**
 * Gives the rows their series and mesh widths. Where unknowns contradict the
 * widths of a series, these are unknown, too.
 * @return a warning for each of these series
 */
std::vector<std::string> place_rows(const std::vector<Factor> &factors,
                                    StudyResult &result);

/**
 * Reads the results of all runs, and computes errors, orders and Pareto front.
 * Skips tasks without outcome.
 * @throws InputError when a finished run lacks the quantity of the error, and
 * for a further column that no run has, unless it may be missing
 */
StudyResult evaluate(const StudyParameters &parameters,
                     const std::vector<Task> &tasks);
} // namespace contrecoup::study

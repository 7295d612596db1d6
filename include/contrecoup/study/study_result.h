// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/study_parameters.h>
#include <contrecoup/study/variant_runner.h>

#include <limits>

namespace contrecoup::study
{
/// A row of the study's table.
struct ResultRow
{
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  Variant variant;
  Outcome outcome;
  std::string folder;     ///< output folder of the run
  std::size_t series = 0; ///< rows of a series differ only in refinement
  double width = unknown; ///< relative mesh width [-]
  double cells = unknown, unknowns = unknown, steps = unknown;
  double retries = unknown;
  double wall_seconds = unknown; ///< measured by the run [s]
  double core_seconds = unknown;
  double updates = unknown;
  double memory = unknown; ///< [byte]
  double cost = unknown;   ///< the cost that the study uses
  double error = unknown;
  double order = unknown; ///< from the next coarser mesh of the series
  bool on_front = false;  ///< Pareto front of cost and error
  /// Further columns; NaN where the run has no value.
  std::vector<double> columns;
};

/// Results of a study.
struct StudyResult
{
  std::vector<ResultRow> rows;
  std::vector<std::string> series; ///< labels of the series
  /// The recommended row.
  std::optional<std::size_t> recommended;
  std::vector<std::string> remarks; ///< remarks for the user
  /// ResultRow::columns of the reference run; empty without one.
  std::vector<double> reference_columns;
};

/**
 * Reads the results of all runs, and computes errors, orders and Pareto front.
 * Skips tasks without outcome.
 * @throws InputError when a finished run lacks the quantity of the error
 */
StudyResult evaluate(const StudyParameters &parameters,
                     const std::vector<Task> &tasks);
} // namespace contrecoup::study

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/study_parameters.h>
#include <contrecoup/study/variant_runner.h>

#include <limits>

namespace contrecoup::study
{
/// One row of a study's table.
struct ResultRow
{
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  Variant variant;
  Outcome outcome;
  std::string folder;     ///< output folder of the run
  std::size_t series = 0; ///< rows that differ in refinement alone
  double width = unknown; ///< relative mesh width [-]
  double cells = unknown, unknowns = unknown, steps = unknown;
  double retries = unknown;
  double wall_seconds = unknown; ///< of the run itself
  double core_seconds = unknown;
  double updates = unknown;
  double memory = unknown; ///< [byte]
  double cost = unknown;   ///< the one of these that the study names
  double error = unknown;
  double order = unknown; ///< from the next coarser mesh of the series
  bool on_front = false;  ///< Pareto front of cost and error
  /// What the study shows besides; NaN where the run does not have it.
  std::vector<double> columns;
};

/// What a study found.
struct StudyResult
{
  std::vector<ResultRow> rows;
  std::vector<std::string> series; ///< their labels
  /// The row to be recommended.
  std::optional<std::size_t> recommended;
  std::vector<std::string> remarks; ///< what the user should know
  /// ResultRow::columns of the reference run; empty without one.
  std::vector<double> reference_columns;
};

/**
 * Reads what the runs left, and computes errors, orders and Pareto front.
 * Tasks without an outcome are left out.
 * @throws InputError when a finished run lacks the quantity of the error
 */
StudyResult evaluate(const StudyParameters &parameters,
                     const std::vector<Task> &tasks);
} // namespace contrecoup::study

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/column.h>
#include <contrecoup/study/design.h>
#include <contrecoup/study/error_measure.h>

namespace contrecoup::study
{
/// All parameters of a study.
struct StudyParameters
{
  std::string title;
  std::string application;
  std::string parameter_file;
  Settings settings;                  ///< for all variants
  std::vector<ColumnRequest> columns; ///< further columns of the tables
  std::vector<Factor> factors;
  DesignParameters design;
  std::string mode; ///< work precision or stability map
  std::string cost; ///< core seconds, wall seconds, updates or memory
  unsigned int ranks = 1;
  unsigned int cores = 1;
  double time_limit = 0.; ///< of a run [s]; 0: none
  ErrorMeasure error;

  /// Declares subsections "Study", "Error" and "Vary *".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for contradictory entries
  void parse_parameters(dealii::ParameterHandler &prm);

private:
  /// @throws InputError for a setting that each run replaces
  void require_effect() const;
};
} // namespace contrecoup::study

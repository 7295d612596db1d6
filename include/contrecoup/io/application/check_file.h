// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/io/output/manifest.h>

#include <string>
#include <utility>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Findings of --check, for other programs.
  struct CheckReport
  {
    std::string application;
    CostEstimate cost;
    /// Numbers that the run can leave, "*" for any letters: "results.*" in
    /// summary.json, "gauge_measures.csv:*" in a table, "blast/results.*" in
    /// the folder of a stage.
    std::vector<std::string> outputs;
    /// Names and costs of the stages of a scene; empty for others.
    std::vector<std::pair<std::string, CostEstimate>> stages = {};
  };

  /// Numbers in summary.json of a solver with this plan; those of any plan if
  /// it is empty.
  std::vector<std::string>
  summary_outputs(const std::vector<Assumption> &plan = {});

  /// Features that a history can be asked for: "first", "last", "largest", ...
  const std::vector<std::string> &history_features();

  /// Numbers of a history, "FILE.csv:FEATURE:COLUMN".
  /// @param columns "*" for any
  std::vector<std::string>
  history_outputs(const std::string &file,
                  const std::vector<std::string> &columns);

  /// Numbers in the tables and JSON files among @p names, without summary.json.
  /// @param tables numbers of all tables; empty: any in those among @p names
  std::vector<std::string>
  file_outputs(const FileNames &names,
               const std::vector<std::string> &tables = {});

  /// Writes the report as JSON to the file that the environment variable
  /// CONTRECOUP_CHECK_FILE names; nothing without it. Figures that are unknown,
  /// or that a stage has not, are null. For one rank.
  /// @throws SystemError
  void write_check_file(const CheckReport &report);

  /// Reads such a file. @throws SystemError if it is missing or damaged
  CheckReport read_check_file(const std::string &file);
} // namespace io
} // namespace contrecoup

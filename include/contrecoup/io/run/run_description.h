// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/base/run/time_control.h>
#include <contrecoup/io/file/vtk_collection.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Totals and common facts of all starts of a run until now.
  struct RunStarts
  {
    double wall_seconds = 0.;      ///< to the last checkpoint of each start
    double core_seconds = 0.;      ///< processor time, all ranks
    double loop_seconds = 0.;      ///< of wall_seconds, those of the time loop
    double loop_rank_seconds = 0.; ///< the same, summed over the ranks
    std::map<std::string, double> timers;    ///< [s], largest over the ranks
    double peak_memory = 0.;                 ///< [byte]
    std::map<std::string, double> estimates; ///< of the plan, by name
    std::vector<std::string> warnings;       ///< each once
    /// Steps and times [s] of the checkpoints from which starts continued.
    std::vector<std::pair<std::uint64_t, double>> interruptions;
  };

  /// State of run loop and outputs in a checkpoint: run.json.
  struct RunDescription
  {
    std::string application;
    std::string build; ///< of the writing program, see this_build()
    RunState state;
    RunStarts starts;
    std::map<std::string, std::string> parameters;
    std::uint64_t history_bytes = 0;
    std::uint64_t probes_bytes = 0;
    std::vector<CollectionEntry> fields; ///< of fields.pvd
    std::vector<NamedValue> first_values;
  };

  /// Version and git revision of this program: "0.1.0 (a2ee2390193e)".
  std::string this_build();

  /// Converts to JSON; from_text() restores numbers bitwise. The build is
  /// always that of this program.
  std::string to_text(const RunDescription &description);

  /// @throws InputError when @p text is no result of to_text(), or has another
  /// format; names both builds
  RunDescription from_text(const std::string &text);

  /**
   * Compares the entries of two runs, "Section/Entry" and value.
   * @param exempt entries, or sections ending in "/", that may differ
   * @throws InputError naming the first entry that differs
   */
  void require_same_scene(const std::map<std::string, std::string> &before,
                          const std::map<std::string, std::string> &now,
                          const std::vector<std::string> &exempt);
} // namespace io
} // namespace contrecoup

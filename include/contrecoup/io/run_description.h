// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/base/time_control.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// What a checkpoint keeps besides the solver's files: run.json.
  struct RunDescription
  {
    std::string application;
    RunState state;
    std::map<std::string, std::string> parameters;
    std::uint64_t history_bytes = 0;
    std::uint64_t probes_bytes = 0;
    std::vector<std::pair<double, std::string>> fields;
    std::vector<NamedValue> first_values;
  };

  /// As JSON; from_text() gives back every number bit by bit.
  std::string to_text(const RunDescription &description);

  /// @throws InputError when @p text is not what to_text() made.
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

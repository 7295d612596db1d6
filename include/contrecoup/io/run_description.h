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
  /// Of what is in a checkpoint: run.json and the files of solvers. Raise it
  /// with any change of these, so that no other build takes them for its own.
  constexpr int checkpoint_format = 5;

  /// What a checkpoint keeps besides the solver's files: run.json.
  struct RunDescription
  {
    std::string application;
    std::string build; ///< that wrote it, see this_build()
    RunState state;
    std::map<std::string, std::string> parameters;
    std::uint64_t history_bytes = 0;
    std::uint64_t probes_bytes = 0;
    std::vector<std::pair<double, std::string>> fields;
    std::vector<NamedValue> first_values;
  };

  /// Version and git revision of this program, as "0.1.0 (a2ee2390193e)".
  std::string this_build();

  /// As JSON; from_text() gives back every number bit by bit. The build is
  /// always this one.
  std::string to_text(const RunDescription &description);

  /// @throws InputError when @p text is not what to_text() made, or is of
  ///   another format, naming both builds.
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

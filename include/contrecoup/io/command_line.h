// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// What the user asked for on the command line.
  struct CommandLine
  {
    std::string parameter_file;
    std::vector<std::string> overrides; ///< "Section/Entry=value"
    std::string output_folder;
    bool resume = false;
    bool check = false;
    bool print_parameters = false;
    bool help = false;
    bool version = false;
  };

  /**
   * Reads `FILE.prm [--set "Section/Entry=value"]... [--output DIR]
   * [--resume] [--check] [--print-parameters] [--help] [--version]`;
   * `--set=...` and `--output=...` are understood as well. Without
   * `--output` the folder is output/<name of the file>.
   * @throws InputError naming the nearest option for an unknown one, or
   *   when no parameter file is given although one is needed.
   */
  CommandLine parse_command_line(int argc, const char *const *argv);

  /// What --help prints.
  std::string help_text(const std::string &application,
                        const std::string &purpose);
} // namespace io
} // namespace contrecoup

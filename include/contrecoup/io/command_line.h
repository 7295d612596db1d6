// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/collective.h>
#include <contrecoup/base/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>
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
    bool overwrite = false;
    bool check = false;
    bool print_parameters = false;
    bool help = false;
    bool version = false;
  };

  /**
   * Reads `FILE.prm [--set "Section/Entry=value"]... [--output DIR]
   * [--resume] [--overwrite] [--check] [--print-parameters] [--help]
   * [--version]`; `--set=...` and `--output=...` are understood as well.
   * Without `--output` the folder is output/<application>/<name of the file>.
   * @throws InputError naming the nearest option for an unknown one, or
   *   when no parameter file is given although one is needed.
   */
  CommandLine parse_command_line(int argc,
                                 const char *const *argv,
                                 const std::string &application);

  /// The command lines that one of `--check` and several parameter files stands
  /// for, one a file with all options; any other one as it is.
  /// @param arguments as main() gets them, the program's name first
  std::vector<std::vector<std::string>>
  single_commands(const std::vector<std::string> &arguments);

  /**
   * Does the @p work of each of these, one after the other, with the file's
   * name before what is said of it where there are several; writes one line to
   * stderr for each that fails. A signal that asks to stop ends all of it.
   * @return the exit code, of several the largest
   * @param tells whether this process is the one that writes
   */
  int run_each(
    const std::vector<std::string> &arguments,
    const std::function<Failure(const std::vector<std::string> &)> &work,
    bool tells);

  /// What --help prints; @p parallel says how several cores are used.
  std::string help_text(const std::string &application,
                        const std::string &purpose,
                        const std::string &parallel);

  /**
   * What --help, --version or --print-parameters prints; empty when none of
   * them is given.
   * @param declare_parameters declares all entries
   * @throws InputError when a parameter file is given that is not valid
   */
  std::string requested_text(
    const CommandLine &command,
    const std::string &application,
    const std::string &purpose,
    const std::string &parallel,
    const std::function<void(dealii::ParameterHandler &)> &declare_parameters);

  /// Writes such a text to the standard output.
  /// @throws SystemError when that cannot take all of it.
  void print_requested(const std::string &text);

  /// What the user wrote in the parameter file and the overrides, with the
  /// names that @p prm declares. @throws InputError for what cannot be read
  std::vector<Assignment> assignments_of(const CommandLine &command,
                                         const dealii::ParameterHandler &prm);

  /// Hands them to declared entries; logs what may have been overlooked.
  /// @throws InputError for what does not fit them
  void read_parameters(const CommandLine &command,
                       dealii::ParameterHandler &prm);
} // namespace io
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_file.h>
#include <contrecoup/base/parameters/parameter_search.h>
#include <contrecoup/base/system/collective.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// The parsed command line.
  struct CommandLine
  {
    std::string parameter_file;
    std::vector<std::string> overrides; ///< "Section/Entry=value"
    std::string output_folder;
    bool resume = false;
    bool overwrite = false;
    bool check = false;
    bool estimate = false; ///< of scene only
    bool print_parameters = false;
    ParameterForm form = ParameterForm::text; ///< in which they are printed
    std::string wanted_parameters;            ///< section or word; empty: all
    bool verbose = false;
    bool help = false;
    bool version = false;
  };

  /**
   * Parses the command line that `--help` shows; `--estimate` is for "scene"
   * only. Also accepts `--set=...` and `--output=...`. With
   * `--print-parameters` and `--print-parameters=json` a word that is neither a
   * file nor ends in ".prm" is what to look for. Without `--output` the folder
   * is `output/APPLICATION/NAME`, NAME that of the file.
   * @throws InputError for an unknown option, suggesting the nearest one, or
   * when a required parameter file is missing
   */
  CommandLine parse_command_line(int argc,
                                 const char *const *argv,
                                 const std::string &application);

  /// Splits a command line with `--check` and several parameter files into one
  /// command line per file with all options; returns others unchanged.
  /// @param arguments as passed to main(), program name first
  std::vector<std::vector<std::string>>
  single_commands(const std::vector<std::string> &arguments);

  /**
   * Runs @p work for each of single_commands(), one after the other; with
   * several files, prints each file's name first. Writes one line to stderr
   * for each failure. A stop signal ends all of them. The screen gets all
   * lines with `--verbose` alone.
   * @param writes_output whether this process writes output
   * @return the largest exit code
   */
  int run_each(
    const std::vector<std::string> &arguments,
    const std::function<Failure(const std::vector<std::string> &)> &work,
    bool writes_output);

  /// Text of --help. @param parallel explains the use of several cores
  std::string help_text(const std::string &application,
                        const std::string &purpose,
                        const std::string &parallel);

  /**
   * Text of --help, --version or --print-parameters; empty without these
   * options.
   * @param declare_parameters declares all entries
   * @throws InputError for an invalid parameter file
   */
  std::string requested_text(
    const CommandLine &command,
    const std::string &application,
    const std::string &purpose,
    const std::string &parallel,
    const std::function<void(dealii::ParameterHandler &)> &declare_parameters);

  /// Writes such a text to standard output.
  /// @throws SystemError when writing fails
  void print_requested(const std::string &text);

  /// Line for a shell that repeats the run, from this working folder.
  /// @param ranks number of processes
  std::string repeating_command(const CommandLine &command, unsigned int ranks);

  /// Assignments of parameter file and overrides, with names as declared in @p
  /// prm. @throws InputError when the file cannot be read
  std::vector<Assignment> assignments_of(const CommandLine &command,
                                         const dealii::ParameterHandler &prm);

  /// Applies the assignments to @p prm, and logs possible oversights.
  /// @throws InputError for unknown entries and invalid values
  void read_parameters(const CommandLine &command,
                       dealii::ParameterHandler &prm);

  /// Shows the warnings of find_unused() for the applied assignments.
  void warn_of_unused(const CommandLine &command,
                      const dealii::ParameterHandler &prm);
} // namespace io
} // namespace contrecoup

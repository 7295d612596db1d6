// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/collective.h>
#include <contrecoup/io/run/command_line.h>

#include <functional>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Description of an application without time steps, on one process.
  struct ToolDescription
  {
    std::string name;
    std::string purpose; ///< one sentence

    /// Declares all entries.
    std::function<void(dealii::ParameterHandler &)> declare_parameters;

    /// Does the work, or describes it with `--check`.
    /// @throws InputError, NumericsError, SystemError
    std::function<void(const CommandLine &, dealii::ParameterHandler &)>
      execute;
  };

  /**
   * Runs a tool as run_application() runs a solver: command line, parameters,
   * errors, with the same options and exit codes. Does not initialise MPI, so
   * that the tool can start MPI applications; under mpirun all ranks except
   * the first exit at once. Returns the exit code; writes one line to stderr
   * unless it is 0.
   */
  int run_tool(int argc, char **argv, const ToolDescription &description);

  /// As run_tool() within another program, on one rank; returns the failure
  /// instead of printing it.
  Failure run_within(const std::vector<std::string> &arguments,
                     const ToolDescription &description);
} // namespace io
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/collective.h>
#include <contrecoup/io/command_line.h>

#include <functional>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// An application without time steps, which runs on one process.
  struct ToolDescription
  {
    std::string name;
    std::string purpose; ///< one sentence

    /// Declares every entry.
    std::function<void(dealii::ParameterHandler &)> declare_parameters;

    /// Does the work, or with `--check` says what it would be.
    /// @throws InputError, NumericsError, SystemError
    std::function<void(const CommandLine &, dealii::ParameterHandler &)>
      execute;
  };

  /**
   * What run_application() is to a solver: command line, parameters, errors,
   * with the same options and exit codes. MPI is not started, so that the
   * tool can start applications that use it; under mpirun all ranks but the
   * first leave at once. Returns the exit code; writes one line to stderr
   * unless it is 0.
   */
  int run_tool(int argc, char **argv, const ToolDescription &description);

  /// The same within another program, by one rank: tells what went wrong
  /// instead of writing it.
  Failure run_within(const std::vector<std::string> &arguments,
                     const ToolDescription &description);
} // namespace io
} // namespace contrecoup

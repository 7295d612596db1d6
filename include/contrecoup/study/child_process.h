// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace contrecoup::study
{
/// End of a process.
struct ProcessEnd
{
  int exit_code = 0;
  int signal = 0; ///< that ended the process; 0: normal exit
};

/**
 * A program that runs concurrently in its own process group, without input,
 * with its output and errors in files. Environment variables that would make
 * an MPI library join a running job are removed. The child ends when this
 * process ends, and when the object is destroyed.
 */
class ChildProcess
{
public:
  /// @param command program, searched in PATH unless it contains a "/", and
  /// arguments
  /// @param variables of the environment in addition, "NAME=value"
  /// @throws SystemError when the program cannot be started
  ChildProcess(const std::vector<std::string> &command,
               const std::string &output_file,
               const std::string &error_file,
               const std::vector<std::string> &variables = {});
  ~ChildProcess();
  ChildProcess(const ChildProcess &) = delete;
  ChildProcess &operator=(const ChildProcess &) = delete;

  /// End of the process; empty while it runs. Does not wait.
  std::optional<ProcessEnd> poll();

  /// Waits for the end of the process.
  ProcessEnd wait();

  /// Sends a termination signal, and kills the process after @p grace_period
  /// [s].
  void terminate(double grace_period);

  /// Wall time since the start [s].
  double seconds() const;

private:
  void signal_group(int signal) const;

  pid_t id_ = -1;
  std::optional<ProcessEnd> end_;
  std::chrono::steady_clock::time_point begin_;
};

/// Output of a short command.
struct ProcessText
{
  ProcessEnd end;
  std::string output;
  std::string errors; ///< last non-empty line
};

/// Runs a command to its end, with temporary files in @p folder.
ProcessText run_process(const std::vector<std::string> &command,
                        const std::string &folder);

/// Last non-empty line of @p text, without a leading "error: ".
std::string last_line(const std::string &text);
} // namespace contrecoup::study

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
/// How a process ended.
struct ProcessEnd
{
  int exit_code = 0;
  int signal = 0; ///< that ended it; 0: it left by itself
};

/**
 * A program that runs beside this one in a process group of its own, without
 * input, its output and errors going to files. Variables by which an MPI
 * library would take it for a part of a running job are not passed on. It
 * ends when this process does, and when the object goes.
 */
class ChildProcess
{
public:
  /// @param command program, found in PATH unless it has a "/", and arguments
  /// @throws SystemError when it cannot be started
  ChildProcess(const std::vector<std::string> &command,
               const std::string &output_file,
               const std::string &error_file);
  ~ChildProcess();
  ChildProcess(const ChildProcess &) = delete;
  ChildProcess &operator=(const ChildProcess &) = delete;

  /// How it ended; empty while it runs. Does not wait.
  std::optional<ProcessEnd> poll();

  /// Waits until it ends by itself.
  ProcessEnd wait();

  /// Asks it to end, and ends it by force @p patience seconds later.
  void terminate(double patience);

  /// Wall time since it was started [s].
  double seconds() const;

private:
  void signal_group(int signal) const;

  pid_t id_ = -1;
  std::optional<ProcessEnd> end_;
  std::chrono::steady_clock::time_point begin_;
};

/// What a command that is soon done printed.
struct ProcessText
{
  ProcessEnd end;
  std::string output;
  std::string errors; ///< the last line that is not empty
};

/// Runs a command to its end, with temporary files in @p folder.
ProcessText run_process(const std::vector<std::string> &command,
                        const std::string &folder);

/// The last line of @p text that is not empty, without "error: " before it.
std::string last_line(const std::string &text);
} // namespace contrecoup::study

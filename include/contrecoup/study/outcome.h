// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/child_process.h>

#include <map>
#include <optional>
#include <string>

namespace contrecoup::study
{
/**
 * Outcome of a variant. Its kind is one of
 *   stable: finished, of a solver, whose steps may fail;
 *   finished: of another program: scene, anatomy;
 *   retried: finished after step size reductions;
 *   unstable: numerical failure;
 *   refused: invalid input;
 *   timed out: ended by the study's time limit;
 *   failed: system failure, or the process crashed.
 */
struct Outcome
{
  std::string kind;
  std::string reason; ///< one line; empty if finished without retries
  int exit_code = 0;
  double wall_seconds = 0.; ///< of the process [s]
  double time_limit = 0.;   ///< limit of the run [s]; 0: none

  /// Whether the run finished.
  bool is_usable() const;
};

/**
 * Outcome of a process that ended.
 * @param folder output folder of the run
 * @param error_file stderr of the run
 */
Outcome judge(const ProcessEnd &end,
              bool timed_out,
              const std::string &folder,
              const std::string &error_file);

/// Explanation of "retried" for readers of a table.
constexpr const char *retried_in_words =
  "complete; steps that failed were repeated with a smaller size";

/// Whether the run failed because files could not be written: disk full or
/// read-only, quota. Further runs would fail as well.
bool is_storage_failure(const Outcome &outcome);

/// Identity of a variant: application, version, ranks and all entries. Runs of
/// equal identity give the same result.
std::string identity(const std::string &application,
                     const std::string &version,
                     unsigned int ranks,
                     const std::map<std::string, std::string> &entries);

/// Writes the outcome to @p file. @throws SystemError
void write_outcome(const std::string &file,
                   const Outcome &outcome,
                   const std::string &identity);

/**
 * Reads the outcome of an earlier study from @p file, if it is valid:
 * complete, of the same identity, and neither a system failure nor a timeout
 * below @p time_limit. A damaged file is logged.
 */
std::optional<Outcome> read_outcome(const std::string &file,
                                    const std::string &identity,
                                    double time_limit);
} // namespace contrecoup::study

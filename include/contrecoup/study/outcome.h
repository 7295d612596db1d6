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
 * What became of a variant. Its kind is one of
 *   stable: it finished;
 *   retried: it finished after cutting back steps;
 *   unstable: the numerics failed;
 *   refused: bad input;
 *   timed out: ended by the study's time limit;
 *   failed: the machine failed, or the process crashed.
 */
struct Outcome
{
  std::string kind;
  std::string reason; ///< one line; empty if it finished without retries
  int exit_code = 0;
  double wall_seconds = 0.; ///< of the process
  double time_limit = 0.;   ///< that it had [s]; 0: none

  /// Whether it finished.
  bool is_usable() const;
};

/**
 * The outcome of a process that ended.
 * @param folder output folder of the run, whose summary.json is read
 * @param error_file what it wrote to stderr
 */
Outcome judge(const ProcessEnd &end,
              bool timed_out,
              const std::string &folder,
              const std::string &error_file);

/// Whether what the process said tells of files that could not be written: a
/// disk that is full or read-only, a quota. All other runs would end so, too.
bool tells_of_storage(const Outcome &outcome);

/// What tells one variant from all others: application, version, ranks and
/// every entry. Two runs of equal identity give the same result.
std::string identity(const std::string &application,
                     const std::string &version,
                     unsigned int ranks,
                     const std::map<std::string, std::string> &entries);

/// Writes the outcome into @p file. @throws SystemError
void write_outcome(const std::string &file,
                   const Outcome &outcome,
                   const std::string &identity);

/**
 * The outcome that an earlier study left in @p file, if it stands: the file
 * is complete, of the same identity, and does not tell of a failed machine or
 * of a time limit below @p time_limit. That a file is damaged is logged.
 */
std::optional<Outcome> read_outcome(const std::string &file,
                                    const std::string &identity,
                                    double time_limit);
} // namespace contrecoup::study

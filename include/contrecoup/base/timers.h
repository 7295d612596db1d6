// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/mpi.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <string>

namespace contrecoup
{
/**
 * Accumulated wall time by name, for the table at the end of a run and
 * "timers" in summary.json. Measure with TimerScope.
 */
class Timers
{
public:
  struct Entry
  {
    double seconds = 0.;
    std::uint64_t calls = 0;
  };

  /// The timers of this process.
  static Timers &instance();

  /// Forgets everything.
  void reset();

  /// The entry of this name, made on first use; stays where it is.
  Entry &entry(const std::string &name);

  /// Seconds by name, the largest over the ranks. Collective.
  std::map<std::string, double> largest(MPI_Comm communicator) const;

  /// A table of largest() with the share of @p total seconds. Collective.
  std::string table(MPI_Comm communicator, double total) const;

private:
  std::map<std::string, Entry> entries_;
};

/**
 * Adds its own lifetime to a timer:
 * @code
 *   const TimerScope timer("flux");
 * @endcode
 * Costs about 100 ns; scopes may nest, times then overlap.
 */
class TimerScope
{
public:
  explicit TimerScope(const std::string &name);
  ~TimerScope();
  TimerScope(const TimerScope &) = delete;
  TimerScope &operator=(const TimerScope &) = delete;

private:
  Timers::Entry &entry_;
  std::chrono::steady_clock::time_point begin_;
};
} // namespace contrecoup

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
/// Wall time accumulated by name, for the table at the end of a run and for
/// "timers" in summary.json. Use TimerScope to measure.
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

  /// Resets all timers.
  void reset();

  /// Entry with this name, created if necessary; its address is stable.
  Entry &entry(const std::string &name);

  /// Times by name, maximum over all ranks [s]. Collective.
  std::map<std::string, double> largest(MPI_Comm communicator) const;

  /// Table of largest() with percentages of @p total [s]. Collective.
  std::string table(MPI_Comm communicator, double total) const;

private:
  std::map<std::string, Entry> entries_;
};

/**
 * Adds its lifetime to a timer:
 * @code
 *   const TimerScope timer("flux");
 * @endcode
 * Costs about 100 ns. Scopes may nest; times then overlap.
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

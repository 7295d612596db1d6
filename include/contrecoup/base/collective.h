// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/mpi.h>

#include <exception>
#include <functional>
#include <string>

namespace contrecoup
{
/// Exit codes of every application; 128 and the number of a signal when that
/// stopped it, see Stopped.
enum class ExitCode : int
{
  done = 0,
  bad_input = 1,
  numerics_failed = 2,
  system_failed = 3
};

/// What went wrong, in one line, and the exit code that stands for it.
struct Failure
{
  ExitCode code = ExitCode::done;
  std::string message;
};

/// Whether a signal stopped what was to be done.
bool is_stop(const Failure &failure);

/**
 * Makes a Failure of any exception: InputError, NumericsError, SystemError,
 * Stopped, std::bad_alloc (system failed), deal.II's exceptions (one line,
 * without stack trace). What is none of these gets the code @p otherwise.
 */
Failure to_failure(const std::exception_ptr &exception, ExitCode otherwise);

/// Throws the InputError, NumericsError, SystemError or Stopped for a failure.
[[noreturn]] void throw_failure(const Failure &failure);

/**
 * Runs functions on all ranks so that an exception on one of them becomes
 * the same exception on all, without a deadlock. Uses a communicator of its
 * own. When the others are stuck in communication with ranks that failed,
 * one of these prints its line and ends all of them after a while.
 */
class Collective
{
public:
  /// @param patience seconds that a failed rank waits for the others
  explicit Collective(MPI_Comm communicator, double patience = 5.);
  ~Collective();
  Collective(const Collective &) = delete;
  Collective &operator=(const Collective &) = delete;

  /**
   * Runs @p function on all ranks.
   * @param otherwise the exit code of exceptions that say nothing of it
   * @throws InputError, NumericsError or SystemError, the same on all ranks,
   *   when the function threw on any.
   */
  void run(const std::function<void()> &function,
           ExitCode otherwise = ExitCode::system_failed);

  /// As run(), for a function that returns up to eight bits. Returns the
  /// bits that any rank gave.
  unsigned int run_with_flags(const std::function<unsigned int()> &function,
                              ExitCode otherwise = ExitCode::system_failed);

  MPI_Comm communicator() const;

private:
  unsigned int agree(const Failure &own, unsigned int flags);
  void abandon(const Failure &own) const;

  MPI_Comm communicator_;
  MPI_Comm agreement_;
  double patience_;
  int rank_;
  int n_ranks_;
};
} // namespace contrecoup

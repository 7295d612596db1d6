// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/mpi.h>

#include <exception>
#include <functional>
#include <string>

namespace contrecoup
{
/// Exit codes of every application; after a stop by a signal 128 plus the
/// signal's number, see Stopped.
enum class ExitCode : int
{
  done = 0,
  bad_input = 1,
  numerics_failed = 2,
  system_failed = 3
};

/// An error message in one line, and its exit code.
struct Failure
{
  ExitCode code = ExitCode::done;
  std::string message;
};

/// Whether the failure is a stop by a signal.
bool is_stop(const Failure &failure);

/**
 * Converts any exception to a Failure: InputError, NumericsError, SystemError,
 * Stopped, std::bad_alloc (system failed), deal.II's exceptions (one line,
 * without stack trace). Other exceptions get the code @p otherwise.
 */
Failure to_failure(const std::exception_ptr &exception, ExitCode otherwise);

/// Throws the InputError, NumericsError, SystemError or Stopped of a failure.
[[noreturn]] void throw_failure(const Failure &failure);

/**
 * Runs functions on all ranks such that an exception on one rank is thrown on
 * all ranks, without deadlock. Uses a separate communicator. If other ranks
 * are blocked in communication with failed ranks, one of the failed ranks
 * prints its message and aborts the job after some time.
 */
class Collective
{
public:
  /// @param timeout time that a failed rank waits for the others [s]
  explicit Collective(MPI_Comm communicator, double timeout = 5.);
  ~Collective();
  Collective(const Collective &) = delete;
  Collective &operator=(const Collective &) = delete;

  /**
   * Runs @p function on all ranks.
   * @param otherwise exit code of exceptions without one
   * @throws InputError, NumericsError or SystemError on all ranks if the
   * function threw on any rank
   */
  void run(const std::function<void()> &function,
           ExitCode otherwise = ExitCode::system_failed);

  /// As run(), for a function that returns up to eight bits. Returns the
  /// bitwise OR over all ranks.
  unsigned int run_with_flags(const std::function<unsigned int()> &function,
                              ExitCode otherwise = ExitCode::system_failed);

  MPI_Comm communicator() const;

private:
  unsigned int combine_failures(const Failure &own, unsigned int flags);
  void abort_all(const Failure &own) const;

  MPI_Comm communicator_;
  MPI_Comm agreement_;
  double timeout_;
  int rank_;
  int n_ranks_;
};
} // namespace contrecoup

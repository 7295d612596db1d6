// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <stdexcept>

namespace contrecoup
{
/**
 * Handles SIGTERM, SIGINT and SIGUSR1 for its lifetime, so that a run can
 * write a checkpoint and exit; a second SIGINT ends the process at once.
 * SIGUSR1 is included because Open MPI's mpirun forwards it to all ranks,
 * whereas it kills the ranks a second after the other signals. Ignores
 * SIGXFSZ, so that a file size limit becomes a write error.
 */
class SignalGuard
{
public:
  SignalGuard();
  ~SignalGuard();
  SignalGuard(const SignalGuard &) = delete;
  SignalGuard &operator=(const SignalGuard &) = delete;

  /// The signal that this process received, or 0.
  static int stop_signal();

  /// @throws Stopped when this process received a signal
  static void require_no_stop();

private:
  void (*old_terminate_)(int);
  void (*old_interrupt_)(int);
  void (*old_user_)(int);
  void (*old_file_size_)(int);
};

/// Thrown when work ends early because of a signal; the exit code is 128 plus
/// the signal number: SIGINT (Ctrl-C) 130, SIGTERM 143, SIGUSR1 138.
class Stopped : public std::runtime_error
{
public:
  explicit Stopped(int signal);
  int signal() const
  {
    return signal_;
  }

private:
  int signal_;
};
} // namespace contrecoup

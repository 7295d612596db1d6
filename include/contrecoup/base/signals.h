// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <stdexcept>

namespace contrecoup
{
/**
 * Catches SIGTERM, SIGINT and SIGUSR1 for as long as it lives, so that a run
 * can write a checkpoint and leave; a second SIGINT ends the process at once.
 * SIGUSR1 is what Open MPI's mpirun hands on to all ranks, while after the
 * others it kills them a second later. Ignores SIGXFSZ, so that a file size
 * limit shows as a failed write.
 */
class SignalGuard
{
public:
  SignalGuard();
  ~SignalGuard();
  SignalGuard(const SignalGuard &) = delete;
  SignalGuard &operator=(const SignalGuard &) = delete;

  /// The signal by which this process was asked to stop, or 0.
  static int stop_signal();

  /// @throws Stopped when this process was asked to stop
  static void require_no_stop();

private:
  void (*old_terminate_)(int);
  void (*old_interrupt_)(int);
  void (*old_user_)(int);
  void (*old_file_size_)(int);
};

/// What was asked for ends before it is finished because of a signal, with
/// the exit code 128 and the signal's number: SIGINT (Ctrl-C) 130, SIGTERM
/// 143, SIGUSR1 138.
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

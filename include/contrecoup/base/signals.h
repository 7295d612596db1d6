// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

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

  /// Whether this process was asked to stop.
  static bool stop_requested();

private:
  void (*old_terminate_)(int);
  void (*old_interrupt_)(int);
  void (*old_user_)(int);
  void (*old_file_size_)(int);
};
} // namespace contrecoup

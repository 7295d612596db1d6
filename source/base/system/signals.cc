// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/signals.h>

#include <csignal>
#include <string>

namespace contrecoup
{
namespace
{
  volatile std::sig_atomic_t stop_flag = 0;

  std::string name_of(const int signal)
  {
    return signal == SIGINT    ? "SIGINT"
           : signal == SIGTERM ? "SIGTERM"
           : signal == SIGUSR1 ? "SIGUSR1"
                               : "signal " + std::to_string(signal);
  }

  void request_stop(const int signal)
  {
    stop_flag = signal;
    if (signal == SIGINT)
      std::signal(signal, SIG_DFL);
  }
} // namespace

SignalGuard::SignalGuard()
{
  stop_flag = 0;
  old_terminate_ = std::signal(SIGTERM, request_stop);
  old_interrupt_ = std::signal(SIGINT, request_stop);
  old_user_ = std::signal(SIGUSR1, request_stop);
  old_file_size_ = std::signal(SIGXFSZ, SIG_IGN);
}

SignalGuard::~SignalGuard()
{
  std::signal(SIGTERM, old_terminate_);
  std::signal(SIGINT, old_interrupt_);
  std::signal(SIGUSR1, old_user_);
  std::signal(SIGXFSZ, old_file_size_);
}

int SignalGuard::stop_signal()
{
  return stop_flag;
}

void SignalGuard::require_no_stop()
{
  if (stop_flag != 0)
    throw Stopped(stop_flag);
}

Stopped::Stopped(const int signal)
  : std::runtime_error("asked to stop by " + name_of(signal))
  , signal_(signal)
{}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <iostream>
#include <sstream>

namespace contrecoup
{
/// Keeps std::cerr quiet while it lives: deal.II tells it about a bad
/// expression before it throws, and the message of the exception says it all.
class Silence
{
public:
  Silence()
    : before_(std::cerr.rdbuf(unread_.rdbuf()))
  {}

  ~Silence()
  {
    std::cerr.rdbuf(before_);
  }

  Silence(const Silence &) = delete;
  Silence &operator=(const Silence &) = delete;

private:
  std::ostringstream unread_;
  std::streambuf *before_;
};
} // namespace contrecoup

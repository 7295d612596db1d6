// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <iostream>
#include <sstream>

namespace contrecoup
{
/// Silences std::cerr for its lifetime: deal.II prints a message about an
/// invalid expression before it throws an exception with the same information.
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

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/log_words.h>

#include <utility>

namespace contrecoup
{
namespace
{
  LogWords::Translation &current()
  {
    static LogWords::Translation translation;
    return translation;
  }
} // namespace

LogWords::LogWords(const Translation &translation)
  : before_(std::exchange(current(), translation))
{}

LogWords::~LogWords()
{
  current() = std::move(before_);
}

std::string LogWords::of(const std::string &text)
{
  return current() ? current()(text) : text;
}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <functional>
#include <string>

namespace contrecoup
{
/// Translates log lines during its lifetime, for a program that runs another
/// one with entries that its user did not write. The latest object applies.
class LogWords
{
public:
  using Translation = std::function<std::string(const std::string &)>;

  explicit LogWords(const Translation &translation);
  ~LogWords();
  LogWords(const LogWords &) = delete;
  LogWords &operator=(const LogWords &) = delete;

  /// Translates @p text for the log.
  static std::string of(const std::string &text);

private:
  Translation before_;
};
} // namespace contrecoup

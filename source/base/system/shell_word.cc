// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/shell_word.h>

#include <boost/algorithm/string/replace.hpp>

namespace contrecoup
{
std::string shell_word(const std::string &text)
{
  const char *plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                      "0123456789/._-+:,@";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos)
    return text;
  return "'" + boost::replace_all_copy(text, "'", "'\\''") + "'";
}
} // namespace contrecoup

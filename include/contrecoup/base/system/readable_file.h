// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
/// Reason why a file cannot be read: "there is no such file", "it is a
/// folder", "permission denied"; empty if it can be read.
std::string why_unreadable(const std::string &file);

/// @throws InputError "cannot read WHAT "FILE": WHY" unless the file can be
/// read
/// @param what kind of file, with article: "the table"
void require_readable(const std::string &what, const std::string &file);

/**
 * Returns the content of a text file. Line ends become "\n", a UTF-8 byte
 * order mark is removed.
 * @throws InputError when the file cannot be read, exceeds @p most_bytes, or
 * is UTF-16 or binary
 */
std::string read_text(const std::string &what,
                      const std::string &file,
                      std::size_t most_bytes = std::size_t(1) << 32);

/// @p text in double quotes for a message: the first 60 characters if it is
/// longer, with "?" for unprintable characters.
std::string quotation(const std::string &text);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
/// Why @p file cannot be read: "there is no such file", "it is a folder",
/// "permission denied"; empty when it can be.
std::string why_unreadable(const std::string &file);

/// @throws InputError "cannot read <what> "<file>": <why>" unless it can be
///   read; @p what names the kind of file with its article, "the table".
void require_readable(const std::string &what, const std::string &file);

/**
 * The content of a text file. Line ends become "\n", a byte order mark of
 * UTF-8 is left out.
 * @throws InputError when it cannot be read, has more than @p most_bytes, or is
 *   no text, but UTF-16 or binary
 */
std::string read_text(const std::string &what,
                      const std::string &file,
                      std::size_t most_bytes = std::size_t(1) << 32);

/// @p text in double quotes for a message: its first 60 characters when it is
/// longer, and "?" for what cannot be printed on a line.
std::string quotation(const std::string &text);
} // namespace contrecoup

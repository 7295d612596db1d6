// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
/// Reason why a text is not UTF-8, with the first wrong byte and what precedes
/// it; empty for UTF-8.
std::string why_not_utf8(const std::string &text);

/// Names the first letter of UTF-8 text that looks like another one and is
/// none, such as a no-break space or a minus sign, with its code point, what
/// precedes it, and what to write instead; empty if there is none.
std::string find_lookalike(const std::string &text);

/// The same for the first letter that is not ASCII, which no number has.
std::string find_foreign_letter(const std::string &text);
} // namespace contrecoup

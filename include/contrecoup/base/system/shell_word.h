// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
/// The text as one word of a command line for a shell, quoted where that is
/// needed.
std::string shell_word(const std::string &text);
} // namespace contrecoup

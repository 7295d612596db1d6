// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <utility>
#include <vector>

/// Values that an entry allows, from the description of its deal.II pattern.
namespace contrecoup
{
/// Words for it: "a number from 0 to 1"; empty where anything is allowed.
std::string plain_words(const std::string &pattern);

/// Least and largest value of a number, or of each in a list, as text; empty
/// without bound, and of other patterns.
std::pair<std::string, std::string> range_of(const std::string &pattern);

/// Whether it is a number, a list of numbers, or a number or a word.
bool is_of_numbers(const std::string &pattern);

/// The words of which one is allowed; empty for other patterns.
std::vector<std::string> choices_of(const std::string &pattern);

/// The unit in an entry's documentation, "[kg] Mass" or "Corner [m]"; "-"
/// without dimension, empty if none is given.
std::string unit_in(const std::string &documentation);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
/// @p text without white space at both ends.
std::string trim(const std::string &text);

/// The parts of @p text between separators, each trimmed. An empty text has
/// no parts.
std::vector<std::string> split(const std::string &text, char separator);

/// The parts with @p separator between them.
std::string join(const std::vector<std::string> &parts,
                 const std::string &separator);

/// @p text with every run of white space and line ends made one space.
std::string one_line(const std::string &text);

/// @p text broken into lines of at most @p width characters.
std::vector<std::string> wrap(const std::string &text, std::size_t width);

/// Number of letters to insert, delete, exchange or swap with the neighbour
/// to come from one word to the other, upper and lower case being the same.
std::size_t edit_distance(const std::string &a, const std::string &b);

/// The candidate closest to @p name by edit_distance(); empty if none is
/// near enough to be what was meant.
std::string nearest(const std::string &name,
                    const std::vector<std::string> &candidates);

/// A help for an unknown name: "; did you mean ...?" and, when the list is
/// short, "known are: ...". Starts with "; " unless empty.
std::string suggestion(const std::string &name,
                       const std::vector<std::string> &candidates);

/// The shortest text that brings @p value back bit by bit: "0.005".
std::string exact(double value);

/// @p value with @p digits significant digits, for people.
std::string brief(double value, int digits = 4);

/// A duration in seconds as people say it, e.g. "2 min 05 s".
std::string duration(double seconds);

/// A number of bytes as people say it, e.g. "1.5 GiB".
std::string bytes(double count);
} // namespace contrecoup

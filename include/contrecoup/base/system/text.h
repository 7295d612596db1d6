// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
bool begins_with(const std::string &text, const std::string &beginning);

/// @p text without leading and trailing white space.
std::string trim(const std::string &text);

/// Splits @p text at separators and trims the parts. An empty text has no
/// parts.
std::vector<std::string> split(const std::string &text, char separator);

/// Joins the parts with @p separator.
std::string join(const std::vector<std::string> &parts,
                 const std::string &separator);

/// Replaces every run of white space and line ends in @p text by one space.
std::string one_line(const std::string &text);

/// Breaks @p text into lines of at most @p width characters.
std::vector<std::string> wrap(const std::string &text, std::size_t width);

/// Number of insertions, deletions, substitutions and transpositions of
/// adjacent letters between two words, ignoring case.
std::size_t edit_distance(const std::string &a, const std::string &b);

/// The candidate that is meant by @p name: one that begins with it, ignoring
/// case, if it has three letters at least; else one that is close enough, or
/// empty. Among several, the closest one by edit_distance() counts.
std::string nearest(const std::string &name,
                    const std::vector<std::string> &candidates);

/// Suggestion for an unknown name: "; did you mean ...?" and, for a short
/// list, "known are: ...". Starts with "; " unless empty.
std::string suggestion(const std::string &name,
                       const std::vector<std::string> &candidates);

/// Shortest text that restores @p value bitwise: "0.005".
std::string exact(double value);

/// @p value with @p digits significant digits, for readers.
std::string brief(double value, int digits = 4);

/// A duration in seconds in readable form, e.g. "2 min 05 s".
std::string duration(double seconds);

/// A number of bytes in readable form, e.g. "1.5 GiB".
std::string bytes(double count);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
/// One "set entry = value" of the user.
struct Assignment
{
  std::vector<std::string> sections; ///< subsections, outermost first
  std::string entry;
  std::string value;
  std::string origin;      ///< "\"file.prm\", line 7[, included]" or "--set"
  std::string folder = {}; ///< of the parameter file; empty for --set
};

/**
 * Reads a parameter file in deal.II's syntax: `subsection NAME`, `end`, `set
 * ENTRY = VALUE`, `include FILE` (relative to the including file), `#` starts
 * a comment, `\` at the end of a line joins it with the next. Does not check
 * which entries exist.
 * @throws InputError for a missing file or a syntax error, with file and line
 */
std::vector<Assignment> read_assignments(const std::string &file);

/**
 * Parses "Section/Subsection/Entry=value" of `--set`.
 * @throws InputError for another form
 */
Assignment parse_override(const std::string &text);
} // namespace contrecoup

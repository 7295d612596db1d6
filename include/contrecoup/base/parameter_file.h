// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
/// One "set entry = value" as the user wrote it.
struct Assignment
{
  std::vector<std::string> sections; ///< subsections from the outermost in
  std::string entry;
  std::string value;
  std::string origin;      ///< "\"file.prm\", line 7" or "--set"
  std::string folder = {}; ///< of the parameter file; empty for --set
};

/**
 * Reads a parameter file of deal.II's grammar: `subsection NAME`, `end`,
 * `set ENTRY = VALUE`, `include FILE` (relative to the including file), `#`
 * starts a comment, `\` at the end of a line joins it with the next. Says
 * nothing about which entries exist.
 * @throws InputError for a missing file or wrong syntax, with file and line.
 */
std::vector<Assignment> read_assignments(const std::string &file);

/**
 * Reads "Section/Subsection/Entry=value" as given to `--set`.
 * @throws InputError when it has not this form.
 */
Assignment parse_override(const std::string &text);
} // namespace contrecoup

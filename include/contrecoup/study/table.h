// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup::study
{
/// The header of a CSV file of a run, "name [unit],...".
struct TableHead
{
  std::vector<std::string> names; ///< of the columns, without units
  std::vector<std::string> units; ///< of the columns; empty: none

  /// Whether the rows are a history: one of the first two columns is "time".
  bool is_history() const;
};

/// A CSV file of a run, whose cells are texts or numbers.
struct Table : TableHead
{
  std::vector<std::vector<std::string>> rows;

  /// Name of a row: its texts before the first number, separated by blanks;
  /// without any text its first cell.
  std::string row_name(std::size_t row) const;
};

/// Reads the header alone.
/// @throws InputError when the file cannot be read or is empty
TableHead read_head(const std::string &file);

/// Reads a table. Quoted cells may hold commas.
/// @throws InputError when the file cannot be read, is empty, or for a row with
/// too few or too many cells
Table read_table(const std::string &file);
} // namespace contrecoup::study

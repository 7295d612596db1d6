// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// A table written by HistoryFile.
  struct HistoryTable
  {
    std::vector<std::string> names;           ///< column names, without units
    std::vector<std::vector<double>> columns; ///< all of the same length

    /// Returns the column with this name.
    /// @throws InputError, naming @p file, for an unknown column
    const std::vector<double> &column(const std::string &name,
                                      const std::string &file) const;
  };

  /// Reads a table.
  /// @throws InputError when the file cannot be read, or for a row with
  /// invalid or too few or too many numbers
  HistoryTable read_history(const std::string &file);
} // namespace io
} // namespace contrecoup

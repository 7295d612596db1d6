// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// A table as HistoryFile writes it.
  struct HistoryTable
  {
    std::vector<std::string> names;           ///< of columns, without units
    std::vector<std::vector<double>> columns; ///< all of the same length

    /// The column of that name.
    /// @throws InputError that names @p file when there is none
    const std::vector<double> &column(const std::string &name,
                                      const std::string &file) const;
  };

  /// Reads the table in @p file.
  /// @throws InputError when it cannot be read, or for a row with more or fewer
  /// numbers than the header has names, or with what is no number
  HistoryTable read_history(const std::string &file);
} // namespace io
} // namespace contrecoup

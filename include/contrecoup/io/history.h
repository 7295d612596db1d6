// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /**
   * A table with one header line, `name [unit]` by column, and one row per
   * output tick with 17 significant digits. Used on one rank. Rows reach
   * the file in blocks, at least every two seconds and at flush().
   */
  class HistoryFile
  {
  public:
    explicit HistoryFile(const std::string &file);
    ~HistoryFile();
    HistoryFile(const HistoryFile &) = delete;
    HistoryFile &operator=(const HistoryFile &) = delete;

    /// Removes what an earlier run left.
    void start();

    /// Cuts the file back to its first @p n_bytes and goes on from there.
    /// @throws InputError when it is shorter.
    void resume(std::uint64_t n_bytes);

    /// Adds a row; the first one of a file makes its header.
    /// @throws InputError when the columns are not those of the header
    /// @throws SystemError when the disk is full
    void add_row(const std::vector<NamedValue> &row);

    /// Writes what add_row() still holds. @throws SystemError; the file
    /// then ends with its last complete block.
    void flush();

    /// Size of the file after a flush() [byte].
    std::uint64_t size() const;

  private:
    std::string file_;
    std::string header_;
    std::string pending_;
    std::uint64_t size_ = 0;
    std::chrono::steady_clock::time_point last_flush_;
  };
} // namespace io
} // namespace contrecoup

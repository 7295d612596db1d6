// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /**
   * A CSV table with the header `name [unit]` and one row per output time,
   * with 17 significant digits. For use on one rank. Rows are written in
   * blocks, at least every two seconds and at flush().
   */
  class HistoryFile
  {
  public:
    explicit HistoryFile(const std::string &file);
    ~HistoryFile();
    HistoryFile(const HistoryFile &) = delete;
    HistoryFile &operator=(const HistoryFile &) = delete;

    /// Removes the file of an earlier run.
    void start();

    /// Truncates the file to @p n_bytes and appends from there.
    /// @throws InputError when the file is shorter
    void resume(std::uint64_t n_bytes);

    /// Adds a row; the first row determines the header.
    /// @throws InputError when the columns differ from the header
    /// @throws SystemError when the disk is full
    void add_row(const std::vector<NamedValue> &row);

    /// Writes pending rows. @throws SystemError; the file then ends with its
    /// last complete block
    void flush();

    /// Size of the file after flush() [byte].
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

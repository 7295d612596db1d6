// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

namespace contrecoup
{
namespace io
{
  /// Bytes at most that one byte compressed by zlib can become.
  constexpr std::uint64_t largest_zlib_ratio = 1032;

  /**
   * Writes a file atomically: into a temporary file next to it, which is
   * renamed when complete. On failure (disk full) nothing is left.
   * @param write writes the content to the stream
   * @throws SystemError with the system's reason
   */
  void write_file(const std::string &file,
                  const std::function<void(std::ostream &)> &write);

  /// Returns the content of a file. @throws SystemError when it cannot be read
  std::string read_file(const std::string &file);

  /// Copies a file atomically, as write_file().
  /// @throws SystemError with the system's reason
  void copy_file(const std::string &source, const std::string &target);

  /// Flushes a file or folder to the disk. @throws SystemError
  void sync(const std::string &path);

  /// Removes a file, or a folder with its content; never throws.
  void remove_quietly(const std::string &path) noexcept;
} // namespace io
} // namespace contrecoup

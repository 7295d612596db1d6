// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace contrecoup
{
namespace io
{
  /**
   * Writes @p file as a whole: into a temporary file beside it that takes
   * its name when complete. On failure (disk full) nothing is left.
   * @param write puts the content into the stream
   * @throws SystemError with the system's reason
   */
  void write_file(const std::string &file,
                  const std::function<void(std::ostream &)> &write);

  /// The content of a file. @throws SystemError when it cannot be read.
  std::string read_file(const std::string &file);

  /// Makes @p target the same as @p source, as write_file() does.
  /// @throws SystemError with the system's reason
  void copy_file(const std::string &source, const std::string &target);

  /// Brings a file or folder to the disk. @throws SystemError
  void sync(const std::string &path);

  /// Removes a file or a folder with all it holds; never throws.
  void remove_quietly(const std::string &path) noexcept;
} // namespace io
} // namespace contrecoup

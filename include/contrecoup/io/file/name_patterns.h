// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// @name Files of a folder by patterns such as "fields/plane_*_#.vti": #
  /// stands for one or more digits, * for any characters of a name.
  /// @{

  /// Whether a name without folders matches a pattern.
  bool matches(const std::string &name, const std::string &pattern);

  /**
   * Files, relative to @p folder, that match any of the patterns, sorted and
   * without duplicates. Includes incomplete files of write_file() and symbolic
   * links, but no folders.
   */
  std::vector<std::string> find_files(const std::string &folder,
                                      const std::vector<std::string> &patterns);

  /**
   * Removes files, and then those of their subfolders that are empty; @p
   * folder itself stays. Missing files are ignored.
   * @throws SystemError when a file cannot be removed
   */
  void remove_files(const std::string &folder,
                    const std::vector<std::string> &files);
  /// @}
} // namespace io
} // namespace contrecoup

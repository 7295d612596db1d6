// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// @name Files of a folder by patterns such as "fields/plane_*_#.npy", in
  /// which # stands for one or more digits and * for any characters of a name.
  /// @{

  /// Whether a name, without folders, fits a pattern.
  bool fits(const std::string &name, const std::string &pattern);

  /**
   * The files, relative to @p folder, that fit one of the patterns, sorted,
   * each once; also those that write_file() had not finished. A symbolic link
   * is such a file; a folder is none.
   */
  std::vector<std::string> find_files(const std::string &folder,
                                      const std::vector<std::string> &patterns);

  /**
   * Removes these files, and of the subfolders that they were in those which
   * are empty then; @p folder itself stays. Files that are gone already do not
   * matter.
   * @throws SystemError when a file cannot be removed
   */
  void remove_files(const std::string &folder,
                    const std::vector<std::string> &files);
  /// @}
} // namespace io
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
namespace io
{
  /// A new folder for temporary files; the destructor removes it.
  class TemporaryFolder
  {
  public:
    /// @throws SystemError when it cannot be created
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    const std::string &path() const;

  private:
    std::string path_;
  };
} // namespace io
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/temporary_folder.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace contrecoup
{
namespace io
{
  TemporaryFolder::TemporaryFolder()
  {
    std::error_code ignored;
    path_ =
      (std::filesystem::temp_directory_path(ignored) / "contrecoup_XXXXXX")
        .string();
    if (mkdtemp(path_.data()) == nullptr)
      throw SystemError("cannot make the temporary folder \"" + path_ +
                        "\": " + std::strerror(errno));
  }

  TemporaryFolder::~TemporaryFolder()
  {
    remove_quietly(path_);
  }

  const std::string &TemporaryFolder::path() const
  {
    return path_;
  }
} // namespace io
} // namespace contrecoup

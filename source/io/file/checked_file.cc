// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/checked_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace contrecoup
{
namespace io
{
  namespace
  {
    SystemError failed(const std::string &file, const int reason)
    {
      return SystemError(
        "cannot write \"" + file +
        "\": " + (reason != 0 ? std::strerror(reason) : "is the disk full?"));
    }
  } // namespace

  void write_file(const std::string &file,
                  const std::function<void(std::ostream &)> &write)
  {
    const std::string partial = file + ".partial";
    errno = 0;
    try
    {
      std::ofstream output(partial, std::ios::binary);
      if (!output)
        throw failed(file, errno);
      write(output);
      const bool written = static_cast<bool>(output.flush());
      const int reason = errno;
      output.close();
      if (!written || !output)
        throw failed(file, reason);
    }
    catch (...)
    {
      const int reason = errno;
      remove_quietly(partial);
      // errno is more precise than a writer's own test of its stream.
      if (reason == ENOSPC || reason == EFBIG || reason == EDQUOT)
        throw failed(file, reason);
      throw;
    }
    std::error_code error;
    std::filesystem::rename(partial, file, error);
    if (error)
    {
      remove_quietly(partial);
      throw failed(file, error.value());
    }
  }

  std::string read_file(const std::string &file)
  {
    std::ifstream input(file, std::ios::binary);
    std::ostringstream content;
    // Inserting an empty file buffer sets the stream's failure state.
    const bool is_empty =
      input && input.peek() == std::ifstream::traits_type::eof();
    if (!is_empty && (!input || !(content << input.rdbuf())))
      throw SystemError("cannot read \"" + file + "\"");
    return content.str();
  }

  void copy_file(const std::string &source, const std::string &target)
  {
    std::ifstream input(source, std::ios::binary);
    if (!input)
      throw SystemError("cannot read \"" + source + "\"");
    write_file(target, [&](std::ostream &out) { out << input.rdbuf(); });
  }

  void sync(const std::string &path)
  {
    const int descriptor = open(path.c_str(), O_RDONLY);
    const int result = descriptor < 0 ? -1 : fsync(descriptor);
    const int reason = errno;
    if (descriptor >= 0)
      close(descriptor);
    if (result != 0)
      throw failed(path, reason);
  }

  void remove_quietly(const std::string &path) noexcept
  {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
} // namespace io
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <cstdint>
#include <string>

namespace contrecoup
{
namespace io
{
  /// What tells whether a file is still as it was.
  struct FileDigest
  {
    std::uint64_t bytes = 0;
    unsigned long crc32 = 0;

    bool operator==(const FileDigest &other) const
    {
      return bytes == other.bytes && crc32 == other.crc32;
    }
  };

  /// Size and CRC-32 of a file, at about 1 GB/s if it is in memory.
  /// @throws SystemError when it cannot be read
  FileDigest digest_of(const std::string &file);
} // namespace io
} // namespace contrecoup

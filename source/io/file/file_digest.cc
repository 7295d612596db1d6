// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/file_digest.h>

#include <zlib.h>

#include <fstream>
#include <vector>

namespace contrecoup
{
namespace io
{
  FileDigest digest_of(const std::string &file)
  {
    std::ifstream input(file, std::ios::binary);
    if (!input)
      throw SystemError("cannot read \"" + file + "\"");
    std::vector<char> block(1 << 20);
    FileDigest digest{0, crc32(0, Z_NULL, 0)};
    while (input)
    {
      input.read(block.data(), static_cast<long>(block.size()));
      const auto n = static_cast<unsigned int>(input.gcount());
      digest.bytes += n;
      digest.crc32 =
        crc32(digest.crc32, reinterpret_cast<const Bytef *>(block.data()), n);
    }
    if (input.bad())
      throw SystemError("cannot read \"" + file + "\"");
    return digest;
  }
} // namespace io
} // namespace contrecoup

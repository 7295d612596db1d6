// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/exceptions.h>

#include <algorithm>
#include <cstdint>
#include <istream>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

/**
 * @file
 * Binary input and output of numbers and lists, for checkpoints.
 */

namespace contrecoup::io
{
/// The file of a rank in a checkpoint's folder.
inline std::string rank_file(const std::string &folder,
                             const std::string &name,
                             const unsigned int rank)
{
  return folder + "/" + name + "." + std::to_string(rank) + ".bin";
}

/// Writes a trivially copyable value.
template <typename Value>
void write_binary(std::ostream &out, const Value &value)
{
  static_assert(std::is_trivially_copyable_v<Value>);
  out.write(reinterpret_cast<const char *>(&value), sizeof(value));
}

/// Reads a value. Callers must check the stream for premature end.
template <typename Value>
void read_binary(std::istream &in, Value &value)
{
  static_assert(std::is_trivially_copyable_v<Value>);
  in.read(reinterpret_cast<char *>(&value), sizeof(value));
}

/// Writes the size of a list and its values.
template <typename Value>
void put_list(std::ostream &out, const std::vector<Value> &list)
{
  static_assert(std::is_trivially_copyable_v<Value>);
  write_binary(out, static_cast<std::uint64_t>(list.size()));
  out.write(reinterpret_cast<const char *>(list.data()),
            static_cast<std::streamsize>(list.size() * sizeof(Value)));
}

/// Reads a list from a stream over a file's content in memory.
/// @param file name for error messages
/// @throws InputError for a list that exceeds the rest of the file
template <typename Value>
void take_list(std::istream &in,
               const std::string &file,
               std::vector<Value> &list)
{
  static_assert(std::is_trivially_copyable_v<Value>);
  std::uint64_t size = 0;
  read_binary(in, size);
  const auto rest = static_cast<std::uint64_t>(
    std::max<std::streamsize>(in.rdbuf()->in_avail(), 0));
  if (!in || size > rest / sizeof(Value))
    throw InputError("Checkpoint file " + file + " ends too early");
  list.resize(size);
  in.read(reinterpret_cast<char *>(list.data()),
          static_cast<std::streamsize>(size * sizeof(Value)));
}
} // namespace contrecoup::io

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/exceptions.h>

#include <algorithm>
#include <cstdint>
#include <istream>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

/**
 * @file
 * Numbers and lists of them in files of checkpoints, bit by bit.
 */

namespace contrecoup::io
{
/// Writes what consists of numbers alone.
template <typename Value>
void put(std::ostream &out, const Value &value)
{
  static_assert(std::is_trivially_copyable_v<Value>);
  out.write(reinterpret_cast<const char *>(&value), sizeof(value));
}

/// Reads it. A stream that ends too early fails, which callers have to check.
template <typename Value>
void take(std::istream &in, Value &value)
{
  static_assert(std::is_trivially_copyable_v<Value>);
  in.read(reinterpret_cast<char *>(&value), sizeof(value));
}

/// Writes how many there are, and these.
template <typename Value>
void put_list(std::ostream &out, const std::vector<Value> &list)
{
  static_assert(std::is_trivially_copyable_v<Value>);
  put(out, static_cast<std::uint64_t>(list.size()));
  out.write(reinterpret_cast<const char *>(list.data()),
            static_cast<std::streamsize>(list.size() * sizeof(Value)));
}

/// Reads a list out of the content of a file that is in memory.
/// @param file for messages
/// @throws InputError for a list that is longer than the rest of the file
template <typename Value>
void take_list(std::istream &in,
               const std::string &file,
               std::vector<Value> &list)
{
  static_assert(std::is_trivially_copyable_v<Value>);
  std::uint64_t size = 0;
  take(in, size);
  const auto rest = static_cast<std::uint64_t>(
    std::max<std::streamsize>(in.rdbuf()->in_avail(), 0));
  if (!in || size > rest / sizeof(Value))
    throw InputError("Checkpoint file " + file + " ends too early");
  list.resize(size);
  in.read(reinterpret_cast<char *>(list.data()),
          static_cast<std::streamsize>(size * sizeof(Value)));
}
} // namespace contrecoup::io

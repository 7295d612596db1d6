// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <fstream>
#include <functional>
#include <ostream>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

/**
 * @file
 * Files of a checkpoint: numbers, lists, and records with the number of a node,
 * cell or tie in the whole mesh, so that any number of ranks restores what
 * others saved.
 */

namespace contrecoup::io
{
/// Places on this rank by numbers in the whole mesh.
using NumberIndex = std::unordered_map<std::uint32_t, std::size_t>;

/// @param number_of place on this rank, from 0 to @p n - 1
template <typename Function>
NumberIndex index_by_number(const std::size_t n, const Function &number_of)
{
  NumberIndex index;
  for (std::size_t i = 0; i < n; ++i)
    index[number_of(i)] = i;
  return index;
}


/// Writes values of a state.
class StateWriter
{
public:
  explicit StateWriter(std::ostream &out)
    : out_(out)
  {}

  void put_bytes(const void *from, const std::size_t n)
  {
    out_.write(static_cast<const char *>(from),
               static_cast<std::streamsize>(n));
  }

  template <typename Value>
  void put(const Value &value)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    put_bytes(&value, sizeof(value));
  }

  template <typename Value>
  void put_list(const std::vector<Value> &list)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    put(static_cast<std::uint64_t>(list.size()));
    put_bytes(list.data(), list.size() * sizeof(Value));
  }

  /// A list of the records that @p record_of gives for 0 to @p n - 1.
  template <typename Function>
  void put_records(const std::size_t n, const Function &record_of)
  {
    put(static_cast<std::uint64_t>(n));
    for (std::size_t i = 0; i < n; ++i)
      put(record_of(i));
  }

private:
  std::ostream &out_;
};


/// Reads values of a state, in the order in which they were written.
class StateReader
{
public:
  /// @param rank that saved the file @throws InputError when it is missing
  explicit StateReader(const std::string &file, const unsigned int rank = 0);

  unsigned int rank() const
  {
    return rank_;
  }

  /// @throws InputError that names the file, as one of another scene
  [[noreturn]] void refuse() const;

  /// All functions from here on throw InputError if the file ends too early.
  void take_bytes(void *to, const std::size_t n);

  template <typename Value>
  void take(Value &value)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    take_bytes(&value, sizeof(value));
  }

  template <typename Value>
  void take_list(std::vector<Value> &list)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    list.resize(take_size(sizeof(Value)));
    take_bytes(list.data(), list.size() * sizeof(Value));
  }

  /// Calls @p use(place, record) for each record of a list that has a place on
  /// this rank, by its member `number`.
  template <typename Record, typename Function>
  void take_records(const NumberIndex &here, const Function &use)
  {
    const std::uint64_t n = take_size(sizeof(Record));
    for (std::uint64_t i = 0; i < n; ++i)
    {
      Record record;
      take(record);
      if (const auto found = here.find(record.number); found != here.end())
        use(found->second, record);
    }
  }

  /// Number of items of a list, of which each has as many bytes.
  std::uint64_t take_size(const std::size_t bytes);

private:
  std::string file_;
  unsigned int rank_;
  std::ifstream in_;
  std::uint64_t left_ = 0; ///< bytes
};


/// Writes a state atomically, as write_file().
void save_state(const std::string &file,
                const std::function<void(StateWriter &)> &write);

/// Writes this rank's part of a state, NAME.RANK.bin.
void save_part(const std::string &folder,
               const std::string &name,
               const MPI_Comm communicator,
               const std::function<void(StateWriter &)> &write);

/// Reads the part of each rank that saved, in their order.
/// @throws InputError without any
void restore_parts(const std::string &folder,
                   const std::string &name,
                   const std::function<void(StateReader &)> &read);
} // namespace contrecoup::io

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <mpi.h>

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

/**
 * @file
 * MPI communication of texts and arrays. deal.II's functions of these names
 * pack any type with Boost, which adds 5 s to the compile time of each source
 * that calls them.
 */

namespace contrecoup
{
/// Gathers the texts of all ranks, in rank order, on all ranks. Collective.
/// @throws SystemError on all ranks when they exceed 2 GiB in total
std::vector<std::string> gather_texts(MPI_Comm communicator,
                                      const std::string &text);

/// Broadcasts the text of rank @p root. Collective.
/// @throws SystemError on all ranks when it exceeds 2 GiB
std::string
broadcast_text(MPI_Comm communicator, const std::string &text, int root);

/// As gather_texts(), for arrays of arithmetic types.
template <typename T>
std::vector<std::vector<T>> gather_arrays(const MPI_Comm communicator,
                                          const std::vector<T> &values)
{
  static_assert(std::is_arithmetic_v<T>, "only numbers are sent as bytes");
  const std::string bytes(reinterpret_cast<const char *>(values.data()),
                          values.size() * sizeof(T));
  std::vector<std::vector<T>> result;
  for (const std::string &of_rank : gather_texts(communicator, bytes))
  {
    std::vector<T> &numbers = result.emplace_back(of_rank.size() / sizeof(T));
    if (!numbers.empty())
      std::memcpy(numbers.data(), of_rank.data(), of_rank.size());
  }
  return result;
}
} // namespace contrecoup

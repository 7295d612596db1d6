// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/gather.h>

#include <cstdint>
#include <limits>
#include <numeric>

namespace contrecoup
{
namespace
{
  /// MPI counts bytes with an int.
  void check_size(const std::uint64_t n_bytes)
  {
    if (n_bytes > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
      throw SystemError("MPI cannot send " + std::to_string(n_bytes) +
                        " bytes at once");
  }
} // namespace

std::vector<std::string> gather_texts(const MPI_Comm communicator,
                                      const std::string &text)
{
  int n_ranks;
  MPI_Comm_size(communicator, &n_ranks);
  if (n_ranks == 1)
    return {text};

  const std::uint64_t own_size = text.size();
  std::vector<std::uint64_t> sizes(n_ranks);
  MPI_Allgather(
    &own_size, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, communicator);
  const std::uint64_t total =
    std::accumulate(sizes.begin(), sizes.end(), std::uint64_t(0));
  check_size(total);

  const std::vector<int> counts(sizes.begin(), sizes.end());
  std::vector<int> starts(n_ranks, 0);
  for (int rank = 1; rank < n_ranks; ++rank)
    starts[rank] = starts[rank - 1] + counts[rank - 1];
  std::string all(total, ' ');
  MPI_Allgatherv(text.data(),
                 static_cast<int>(own_size),
                 MPI_CHAR,
                 all.data(),
                 counts.data(),
                 starts.data(),
                 MPI_CHAR,
                 communicator);
  std::vector<std::string> result;
  for (int rank = 0; rank < n_ranks; ++rank)
    result.push_back(all.substr(starts[rank], counts[rank]));
  return result;
}

std::string broadcast_text(const MPI_Comm communicator,
                           const std::string &text,
                           const int root)
{
  std::uint64_t size = text.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, root, communicator);
  check_size(size);
  std::string result = text;
  result.resize(size);
  MPI_Bcast(
    result.data(), static_cast<int>(size), MPI_CHAR, root, communicator);
  return result;
}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/memory.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>

#ifdef __linux__
#  include <sys/mman.h>
#endif

namespace contrecoup
{
namespace
{
  /// Value in bytes of a line "name: number kB" in /proc; 0 without such a
  /// line.
  double proc_bytes(const std::string &file, const std::string &name)
  {
    std::ifstream input(file);
    for (std::string word; input >> word;)
      if (word == name + ":")
      {
        double kibibytes = 0.;
        input >> kibibytes;
        return 1024. * kibibytes;
      }
    return 0.;
  }

  /// The single number in a file; infinity for "max", or without a file.
  double number_in(const std::string &file)
  {
    std::ifstream input(file);
    double value = 0.;
    return (input >> value) ? value : std::numeric_limits<double>::infinity();
  }

  double available_here()
  {
    const double free = proc_bytes("/proc/meminfo", "MemAvailable");
    const double limit = number_in("/sys/fs/cgroup/memory.max");
    const double used = number_in("/sys/fs/cgroup/memory.current");
    return limit < 1e30 && used < 1e30
             ? std::min(free, std::max(limit - used, 0.))
             : free;
  }
} // namespace

void forget_peak_memory()
{
  // Linux, proc(5): writing 5 resets the high-water mark.
  std::ofstream("/proc/self/clear_refs") << 5;
}

double peak_memory(const MPI_Comm communicator)
{
  return dealii::Utilities::MPI::sum(proc_bytes("/proc/self/status", "VmHWM"),
                                     communicator);
}

double available_memory(const MPI_Comm communicator)
{
  MPI_Comm node;
  int rank_on_node = 0;
  MPI_Comm_split_type(
    communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  MPI_Comm_rank(node, &rank_on_node);
  MPI_Comm_free(&node);
  return dealii::Utilities::MPI::sum(rank_on_node == 0 ? available_here() : 0.,
                                     communicator);
}

void prefer_large_pages([[maybe_unused]] void *memory,
                        [[maybe_unused]] const std::size_t n_bytes)
{
#ifdef __linux__
  constexpr std::uintptr_t page = 4096, large_page = 2U << 20;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + page - 1) / page * page;
  const std::uintptr_t end = (begin + n_bytes) / page * page;
  // A wish: a system without such pages answers with an error, and all
  // continues as before.
  if (end > first && end - first >= large_page)
    madvise(reinterpret_cast<void *>(first), end - first, MADV_HUGEPAGE);
#endif
}
} // namespace contrecoup

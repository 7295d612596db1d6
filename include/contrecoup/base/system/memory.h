// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/mpi.h>

#include <cstddef>

namespace contrecoup
{
/// Peak memory of all ranks, summed [byte]. Collective.
double peak_memory(MPI_Comm communicator);

/// Restarts the measurement of the peak, if the system supports it.
void forget_peak_memory();

/// Memory still available on the machines of all ranks, including container
/// limits [byte]; 0 if unknown. Collective.
double available_memory(MPI_Comm communicator);

/// Asks the system to back memory that is not yet written with pages of 2 MB,
/// where it can.
void prefer_large_pages(void *memory, std::size_t n_bytes);

/// Gives @p vector @p size elements of any value in large pages: the address
/// buffer (TLB) of a processor covers only some megabytes of 4 kB pages, and
/// kernels that read the neighbours of leaves access many more. New memory has
/// room for an eighth more, since the system clears each page that it gives.
template <typename Number>
void resize_in_large_pages(dealii::AlignedVector<Number> &vector,
                           const std::size_t size)
{
  if (vector.capacity() < size || vector.capacity() > 2 * size)
  {
    const std::size_t room = size + size / 8;
    vector.clear();
    vector.reserve(room);
    prefer_large_pages(vector.data(), room * sizeof(Number));
  }
  vector.resize_fast(size);
}
} // namespace contrecoup

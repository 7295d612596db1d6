// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/mpi.h>

namespace contrecoup
{
/// The most memory that the ranks held at once, added up [byte]. Collective.
double peak_memory(MPI_Comm communicator);

/// Counts the peak from now on, where the system can.
void forget_peak_memory();

/// The memory that the machines of all ranks can still give, container
/// limits included [byte]; 0 when the system does not say. Collective.
double available_memory(MPI_Comm communicator);
} // namespace contrecoup

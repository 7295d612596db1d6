// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/mpi.h>

namespace contrecoup
{
/// Peak memory of all ranks, summed [byte]. Collective.
double peak_memory(MPI_Comm communicator);

/// Restarts the measurement of the peak, if the system supports it.
void forget_peak_memory();

/// Memory still available on the machines of all ranks, including container
/// limits [byte]; 0 if unknown. Collective.
double available_memory(MPI_Comm communicator);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/collective.h>
#include <contrecoup/base/exceptions.h>

/// The second rank fails while the first waits for it: both must end, with
/// the message of the second.
int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  contrecoup::Collective collective(MPI_COMM_WORLD, 0.5);
  collective.run([]() {
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 1)
      throw contrecoup::SystemError("the other waits for me");
    MPI_Barrier(MPI_COMM_WORLD);
  });
}

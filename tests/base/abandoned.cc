// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/collective.h>
#include <contrecoup/base/system/exceptions.h>

#include <chrono>
#include <thread>

/// All but the first rank fail, one after the other, while that one waits for
/// them: all must end, with the message of one of them.
int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  contrecoup::Collective collective(MPI_COMM_WORLD, 1.);
  collective.run([]() {
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    if (rank > 0)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(100 * rank));
      throw contrecoup::SystemError("rank 0 waits for rank " +
                                    std::to_string(rank));
    }
    MPI_Barrier(MPI_COMM_WORLD);
  });
}

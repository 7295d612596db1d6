// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/mpi.h>

#include <cstdlib>
#include <functional>
#include <string>

namespace contrecoup
{
/**
 * Body of a benchmark's main function: without arguments it runs the
 * program again under mpirun, on one rank and on two, which measure.
 * @return the exit code
 */
inline int measure_on_ranks(int argc,
                            char **argv,
                            const std::function<void()> &measure_one_rank,
                            const std::function<void()> &measure_two_ranks)
{
  if (argc == 1)
  {
    for (const char *const n_ranks : {"1", "2"})
    {
      const std::string command =
        std::string("mpirun --allow-run-as-root --oversubscribe -np ") +
        n_ranks + " " + argv[0] + " worker";
      if (std::system(command.c_str()) != 0)
        return 1;
    }
    return 0;
  }
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    measure_one_rank();
  else
    measure_two_ranks();
  return 0;
}
} // namespace contrecoup

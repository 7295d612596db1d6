// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/collective.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/memory.h>

#include <deal.II/base/exceptions.h>

#include <gtest/gtest.h>

#include <new>

using namespace contrecoup;
using dealii::Utilities::MPI::n_mpi_processes;
using dealii::Utilities::MPI::this_mpi_process;

namespace
{
template <typename Exception>
Failure failure_of(const Exception &exception)
{
  return to_failure(std::make_exception_ptr(exception),
                    ExitCode::numerics_failed);
}
} // namespace

TEST(Failure, HasExitCodeAndOneLine)
{
  EXPECT_EQ(failure_of(InputError("a\nb")).code, ExitCode::bad_input);
  EXPECT_EQ(failure_of(InputError("a\nb")).message, "a b");
  EXPECT_EQ(failure_of(NumericsError("")).code, ExitCode::numerics_failed);
  EXPECT_EQ(failure_of(SystemError("")).code, ExitCode::system_failed);
  EXPECT_EQ(failure_of(std::bad_alloc()).code, ExitCode::system_failed);
  EXPECT_EQ(failure_of(dealii::ExcIO()).code, ExitCode::system_failed);
  EXPECT_EQ(failure_of(std::runtime_error("odd")).code,
            ExitCode::numerics_failed);
  EXPECT_EQ(failure_of(std::runtime_error("odd")).message, "odd");
  const Failure assertion = failure_of(dealii::ExcMessage("a\n  b"));
  EXPECT_EQ(assertion.code, ExitCode::numerics_failed);
  EXPECT_EQ(assertion.message.find('\n'), std::string::npos);
  EXPECT_NE(assertion.message.find("a b"), std::string::npos);
}

TEST(Collective, AnErrorOfOneRankIsThatOfAll)
{
  Collective collective(MPI_COMM_WORLD);
  const unsigned int last = n_mpi_processes(MPI_COMM_WORLD) - 1;
  const unsigned int rank = this_mpi_process(MPI_COMM_WORLD);
  try
  {
    collective.run([&]() {
      if (rank == last)
        throw NumericsError("rank " + std::to_string(rank));
    });
    ADD_FAILURE() << "nothing was thrown";
  }
  catch (const NumericsError &error)
  {
    EXPECT_EQ(error.what(), "rank " + std::to_string(last));
  }
}

TEST(Collective, TheGravestErrorWins)
{
  Collective collective(MPI_COMM_WORLD);
  EXPECT_THROW(collective.run([&]() {
    if (this_mpi_process(MPI_COMM_WORLD) == 0)
      throw SystemError("disk");
    throw InputError("input");
  }),
               SystemError);
}

TEST(Collective, FlagsOfAllRanksAreJoined)
{
  Collective collective(MPI_COMM_WORLD);
  const unsigned int n = n_mpi_processes(MPI_COMM_WORLD);
  const unsigned int flags = collective.run_with_flags(
    []() { return 1u << this_mpi_process(MPI_COMM_WORLD); });
  EXPECT_EQ(flags, (1u << n) - 1u);
}

TEST(Memory, IsKnown)
{
  EXPECT_GT(peak_memory(MPI_COMM_WORLD), 1e6);
  EXPECT_GT(available_memory(MPI_COMM_WORLD), 1e6);
}

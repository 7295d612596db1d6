// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/base/system/exceptions.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <string>

using namespace contrecoup;

namespace
{
std::string message_of(const Selections &selections, const std::string &remark)
{
  try
  {
    selections.require_some(MPI_COMM_WORLD, remark);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}
} // namespace

TEST(Selections, OneObjectOnOneRankSuffices)
{
  const unsigned int last =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
  const bool is_last =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == last;
  Selections selections;
  selections.add("Supports/Support a/Where", "x < 1", "node", is_last ? 1 : 0);
  EXPECT_EQ(message_of(selections, ""), "");
}

TEST(Selections, AnEntryWithoutAnyIsNamedOnAllRanks)
{
  Selections selections;
  selections.add("Supports/Support a/Where", "x < 1", "node", 3);
  selections.add("Supports/Support b/Where", "x < -1", "node", 0);
  selections.add("Supports/Support b/Where", "x < -1", "node", 0);
  EXPECT_EQ(message_of(selections, "the body lies elsewhere"),
            "Supports/Support b/Where = \"x < -1\" selects no node: the body "
            "lies elsewhere");
  selections.add("Supports/Support b/Where", "x < -1", "node", 1);
  EXPECT_EQ(message_of(selections, ""), "");
}

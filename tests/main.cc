// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lanes.h>

#include <deal.II/base/mpi.h>

#include "source_filter.h"
#include <gtest/gtest.h>

#include <iostream>

/// Runs the unit tests of a program, with MPI ready; every rank reports its own
/// failures, and the run fails when one rank does. With --sources=a.cc,b.cc
/// these are the tests of those files alone.
int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ::testing::InitGoogleTest(&argc, argv);
  const std::string option = "--sources=";
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    std::string filter;
    if (word.compare(0, option.size(), option) == 0)
      filter = filter_of_sources(word.substr(option.size()));
    if (filter.empty())
    {
      std::cerr << word << " chooses no test\n";
      return 1;
    }
    ::testing::GTEST_FLAG(filter) = filter;
  }
  const int failed = RUN_ALL_TESTS();
  return dealii::Utilities::MPI::max(failed, MPI_COMM_WORLD);
}

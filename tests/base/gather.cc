// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/gather.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

using namespace contrecoup;

namespace
{
/// A text of another length on each rank: none on the first, later ones with a
/// byte that ends texts in C.
std::string text_of(const unsigned int rank)
{
  std::string text;
  for (unsigned int i = 0; i < 3 * rank; ++i)
    text += i == 1 ? '\0' : static_cast<char>('a' + rank + i);
  return text;
}

unsigned int this_rank()
{
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
}

unsigned int n_ranks()
{
  return dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
}
} // namespace

TEST(Gather, TextsStandInTheOrderOfRanks)
{
  const auto found = gather_texts(MPI_COMM_WORLD, text_of(this_rank()));
  ASSERT_EQ(found.size(), n_ranks());
  for (unsigned int rank = 0; rank < n_ranks(); ++rank)
    EXPECT_EQ(found[rank], text_of(rank)) << "rank " << rank;
  EXPECT_EQ(gather_texts(MPI_COMM_SELF, "mine"),
            std::vector<std::string>{"mine"});
}

TEST(Gather, ArraysKeepEachBit)
{
  const std::vector<double> mine(this_rank() + 1, 1. / (3. + this_rank()));
  const auto found = gather_arrays(MPI_COMM_WORLD, mine);
  ASSERT_EQ(found.size(), n_ranks());
  for (unsigned int rank = 0; rank < n_ranks(); ++rank)
    EXPECT_EQ(found[rank], std::vector<double>(rank + 1, 1. / (3. + rank)));
  // A rank may have none.
  const auto some = gather_arrays(
    MPI_COMM_WORLD, std::vector<std::uint64_t>(this_rank(), ~std::uint64_t(0)));
  for (unsigned int rank = 0; rank < n_ranks(); ++rank)
    EXPECT_EQ(some[rank], std::vector<std::uint64_t>(rank, ~std::uint64_t(0)));
}

TEST(Gather, EachRankCanSpeakToAll)
{
  for (unsigned int root = 0; root < n_ranks(); ++root)
    EXPECT_EQ(broadcast_text(MPI_COMM_WORLD, text_of(this_rank()), root),
              text_of(root));
}

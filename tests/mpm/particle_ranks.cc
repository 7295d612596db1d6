// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>

#include "particle_case.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::mpm;

namespace
{
/// A sheared block of two materials that moves over several tiles.
/// @return its particles, by mass. Collective.
std::vector<ParticleState> run(const TransferScheme &scheme,
                               const MPI_Comm communicator)
{
  GridBox box;
  box.n_cells = {{16, 12, 10}};
  box.reflects[2] = true;
  std::vector<ParticleMaterial> materials{elastic(1e4, 0.45, 1000.),
                                          elastic(2e4, 0.3, 800.)};
  materials[0].is_smoothed = true;
  ParticleCase block(box, scheme, materials, communicator);
  block.fill(
    [](const auto &x) {
      const bool inside =
        x[0] > 1. && x[0] < 7. && x[1] < 5. && x[2] > 3. && x[2] < 7.;
      return !inside ? -1 : x[0] < 4. ? 0 : 1;
    },
    [](const auto &x) {
      dealii::Tensor<1, 3> v;
      v[0] = 8. + 0.2 * x[2];
      v[1] = 0.1 * std::sin(x[0]);
      v[2] = 0.1 * std::sin(x[1] + x[0]);
      return v;
    },
    {{1, 1, 1}});
  block.tell_apart();
  block.run(0.4, 0.4);
  return block.sorted_states();
}
} // namespace

// On one rank, two and all of the test.
TEST(ParticleRanks, results_do_not_depend_on_their_number)
{
  namespace mpi = dealii::Utilities::MPI;
  const unsigned int n_ranks = mpi::n_mpi_processes(MPI_COMM_WORLD),
                     me = mpi::this_mpi_process(MPI_COMM_WORLD);
  const std::vector<TransferScheme> schemes{
    {2, Transfer::affine, StressUpdate::first, 1},
    {3, Transfer::flip, StressUpdate::modified_last, 2}};
  for (const TransferScheme &scheme : schemes)
  {
    const auto alone = run(scheme, MPI_COMM_SELF);
    ASSERT_EQ(alone.size(), 120u);
    double way = 0.;
    for (const ParticleState &one : alone)
      way = std::max(way, one[1]);
    EXPECT_GT(way, 8.); // into the third tile
    for (const unsigned int n : {2u, n_ranks})
    {
      if (n > 2 && &scheme != &schemes.back())
        continue;
      MPI_Comm some;
      MPI_Comm_split(MPI_COMM_WORLD, me < n ? 0 : 1, me, &some);
      if (me < n)
      {
        const auto shared = run(scheme, some);
        ASSERT_EQ(shared.size(), alone.size());
        EXPECT_LT(largest_difference(shared, alone), 1e-11);
      }
      MPI_Comm_free(&some);
    }
  }
}

TEST(ParticleRanks, a_particle_that_leaves_the_grid_is_one_error_everywhere)
{
  GridBox box;
  box.n_cells = {{24, 4, 4}};
  TransferScheme scheme;
  ParticleCase one(box, scheme, {elastic(1e4, 0.3, 1000.)});
  one.fill([](const auto &x) { return x[0] > 23. ? 0 : -1; },
           [](const auto &) {
             return dealii::Tensor<1, 3>({1., 0., 0.});
           });
  try
  {
    one.run(5., 0.3);
    FAIL() << "nothing was thrown";
  }
  catch (const NumericsError &error)
  {
    const std::string message = error.what();
    EXPECT_NE(message.find("a particle left the grid at (24.0"),
              std::string::npos)
      << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

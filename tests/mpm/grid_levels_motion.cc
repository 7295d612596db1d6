// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "all_schemes.h"
#include "particle_case.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::mpm;

namespace
{
/// A block of rubber that crosses from halved cells into whole ones, and a
/// mirror: two materials, one smoothed. @return its particles, by
/// mass. Collective.
std::vector<ParticleState> crossing_block(const TransferScheme &scheme,
                                          const unsigned int n_steps,
                                          const MPI_Comm communicator)
{
  GridBox box;
  box.n_cells = {{18, 14, 14}};
  box.reflects = {{false, false, true, false, false, false}};
  box.halving.blocks = [](const dealii::Point<3> &lower, const double edge) {
    return lower[0] + edge < 8.5 && lower[2] + edge < 10.5;
  };
  std::vector<ParticleMaterial> materials{elastic(1e4, 0.45, 1000.),
                                          elastic(2e4, 0.3, 800.)};
  materials[0].is_smoothed = true;
  ParticleCase one(box, scheme, materials, communicator);
  one.fill(
    [](const auto &x) {
      const bool inside =
        x[0] > 4. && x[0] < 11. && x[1] < 4. && x[2] > 4. && x[2] < 10.;
      return !inside ? -1 : x[2] < 7. ? 0 : 1;
    },
    [](const auto &x) {
      dealii::Tensor<1, 3> v;
      v[0] = 0.8 + 0.2 * std::sin(0.7 * x[2]);
      v[1] = 0.1 * std::sin(x[1]) * std::cos(0.4 * x[0]);
      v[2] = 0.2 * std::sin(0.5 * x[1] + 0.6 * x[0]);
      return v;
    },
    {{1, 1, 1}});
  one.tell_apart();
  const auto start = one.totals();
  one.advance(0.3 * one.step.signal_time(one.grid, one.particles), n_steps);
  const auto end = one.totals();
  EXPECT_NEAR(one.residual(start), 0., 1e-12 * start.kinetic_energy);
  EXPECT_NEAR(end.mass, start.mass, 1e-14 * start.mass);
  for (const unsigned int d : {0u, 2u})
    EXPECT_NEAR(end.momentum[d], start.momentum[d], 1e-12 * start.mass);
  EXPECT_GT(end.stored_energy, 1e-4 * start.kinetic_energy);
  EXPECT_LT(end.kinetic_energy + end.stored_energy,
            1.02 * start.kinetic_energy);
  return one.sorted_states();
}
} // namespace

// Whatever the scheme, over 300 steps in which cells of matter go from halved
// cells into whole ones.
TEST(GridLevelsMotion, energies_and_momenta_are_kept_across_the_border)
{
  for (const auto transfer :
       {Transfer::pic, Transfer::flip, Transfer::affine, Transfer::fmpm})
    for (const auto update :
         {StressUpdate::first, StressUpdate::last, StressUpdate::modified_last})
    {
      const TransferScheme scheme{3, transfer, update, 2};
      SCOPED_TRACE(scheme_name(scheme));
      crossing_block(scheme, 300, MPI_COMM_SELF);
    }
}

TEST(GridLevelsMotion, results_do_not_depend_on_ranks)
{
  const TransferScheme scheme{
    3, Transfer::flip, StressUpdate::modified_last, 2};
  const auto alone = crossing_block(scheme, 60, MPI_COMM_SELF),
             shared = crossing_block(scheme, 60, MPI_COMM_WORLD);
  ASSERT_EQ(shared.size(), alone.size());
  EXPECT_LT(largest_difference(shared, alone), 1e-11);
}

namespace
{
/// A disk of four whole cells' radius turns by 0.2; its middle lies on the
/// border. @return what is left of its spin, and of its energy
std::array<double, 2> turning_disk(const bool has_halves)
{
  GridBox box;
  box.n_cells = {{16, 16, 1}};
  box.reflects = {{false, false, false, false, true, true}};
  if (has_halves)
    box.halving.blocks = [](const dealii::Point<3> &lower, double) {
      return lower[0] < 8.;
    };
  ParticleCase disk(box,
                    {3, Transfer::flip, StressUpdate::modified_last, 2},
                    {elastic(1e6, 0.3, 1000.)},
                    MPI_COMM_SELF);
  const double radius = 4., middle = 8.,
               rate = 0.02 *
                      disk.step.materials()[0].solid()->dilatational_speed() /
                      radius;
  disk.fill(
    [&](const auto &x) {
      return std::hypot(x[0] - middle, x[1] - middle) < radius ? 0 : -1;
    },
    [&](const auto &x) {
      return dealii::Tensor<1, 3>(
        {-rate * (x[1] - middle), rate * (x[0] - middle), 0.});
    },
    {{2, 2, 1}});
  const auto spin = [&]() {
    return disk.sum([&](const ParticleBlock &one, const std::size_t p) {
      return one[column::mass][p] * ((one[column::position][p] - middle) *
                                       one[column::velocity + 1][p] -
                                     (one[column::position + 1][p] - middle) *
                                       one[column::velocity][p]);
    });
  };
  const auto energy = [&]() {
    const auto totals = disk.totals();
    return totals.kinetic_energy + totals.stored_energy;
  };
  const double first_spin = spin(), first_energy = energy();
  disk.run(0.2 / rate, 0.4);
  return {{spin() / first_spin, energy() / first_energy}};
}
} // namespace

// FLIP loses 2 % of the spin at the free edge, and hardly more at the border.
TEST(GridLevelsMotion, disks_turn_on)
{
  const auto whole = turning_disk(false), halved = turning_disk(true);
  EXPECT_NEAR(whole[0], 1., 0.0203);
  EXPECT_NEAR(halved[0], 1., 0.023);
  EXPECT_NEAR(halved[1], 1., 1.7e-4);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/record/region_history.h>
#include <contrecoup/io/file/temporary_folder.h>

#include "solid_bar.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;

namespace
{
namespace mpi = dealii::Utilities::MPI;
using ale::ExtremeRecord;
using ale::RegionExtremes;

/// Requires that what forces find after steps is what the cells have.
void expect_extremes_of_cells(SolidBar &bar, const ale::Region &region)
{
  double shear = 0.;
  for (unsigned int step = 0; step < 12; ++step)
  {
    bar.step.advance(bar.state, 1., 0.3);
    const RegionExtremes found = bar.step.extremes().front();
    const RegionExtremes exact =
      ale::region_extremes(bar.space, bar.step, bar.state, {region}).front();
    const double scale = std::max(exact.largest_pressure, 1.);
    EXPECT_NEAR(found.least_pressure, exact.least_pressure, 1e-9 * scale);
    EXPECT_NEAR(found.largest_pressure, exact.largest_pressure, 1e-9 * scale);
    EXPECT_NEAR(
      found.shear_strain, exact.shear_strain, 1e-6 * exact.shear_strain);
    EXPECT_NEAR(found.speed, exact.speed, 1e-12 * exact.speed);
    EXPECT_NEAR(
      found.void_volume, exact.void_volume, 1e-12 * exact.void_volume);
    shear = std::max(shear, exact.shear_strain);
  }
  EXPECT_EQ(shear > 1e-3, region.solid() != nullptr);
}

dealii::Tensor<1, 3> stirred(const dealii::Point<3> &x)
{
  return dealii::Tensor<1, 3>({20. * std::sin(9. * x[0] + 2. * x[1]),
                               30. * std::cos(7. * x[0]),
                               10. * x[0] * x[2]});
}
} // namespace

TEST(RegionExtremes, OfSolidsAreThoseOfTheirCells)
{
  for (const auto kinematics : {SolidKinematics::small_strain,
                                SolidKinematics::finite_rotation,
                                SolidKinematics::neo_hookean})
  {
    ale::Region region = elastic_region();
    region.kinematics = kinematics;
    SolidBar bar({9, 3, 2}, 1., {region, {0, 1, 2, 3, 4, 5}, {}, {}}, stirred);
    expect_extremes_of_cells(bar, region);
  }
}

TEST(RegionExtremes, OfLiquidsAreThoseOfTheirCells)
{
  ale::Region region = elastic_region();
  SolidBar bar({9, 3, 2}, 1., {region, {0, 1, 2, 3, 4, 5}, {}, {}}, stirred);
  region.law = Tait(1000., 2e9, 7.15, -1e5);
  bar.step.reinit(
    bar.space, {region}, {}, [](double) { return dealii::Tensor<1, 3>(); });
  bar.step.start(bar.state);
  expect_extremes_of_cells(bar, region);
  EXPECT_GT(bar.step.extremes().front().void_volume, 0.);
}

TEST(RegionExtremes, OfMatterThatExpandsAreNegative)
{
  ale::Region region = elastic_region();
  SolidBar bar({3, 3, 3},
               1.,
               {region, {0, 1, 2, 3, 4, 5}, {}, {}},
               [](const dealii::Point<3> &x) { return 10. * x; });
  bar.step.advance(bar.state, 1., 0.3);
  const RegionExtremes found = bar.step.extremes().front();
  EXPECT_LT(found.largest_pressure, -1e5);
  EXPECT_LE(found.least_pressure, found.largest_pressure);
}

TEST(ExtremeRecord, HasAllStepsSinceTheRowBefore)
{
  const double rank = mpi::this_mpi_process(MPI_COMM_WORLD);
  const double n_ranks = mpi::n_mpi_processes(MPI_COMM_WORLD);
  ExtremeRecord record;
  record.reinit(1, MPI_COMM_WORLD);
  EXPECT_TRUE(record.is_empty());
  record.add({{-3. - rank, 5. + rank, 0.1, 2., 1.}});
  record.add({{-1., 7., 0.2, 1., 0.5}});
  // A checkpoint between rows.
  const io::TemporaryFolder folder;
  const std::string file = folder.path() + "/extremes.bin";
  io::save_state(file, [&](io::StateWriter &out) { record.save(out); });
  ExtremeRecord resumed;
  resumed.reinit(1, MPI_COMM_WORLD);
  io::StateReader in(file);
  resumed.restore(in);
  for (ExtremeRecord *one : {&record, &resumed})
  {
    one->add({{0., 6., 0.15, 0., 0.75}});
    const RegionExtremes row = one->take().front();
    EXPECT_EQ(row.least_pressure, -3. - (n_ranks - 1.));
    EXPECT_TRUE(one->is_least_last(0));
    EXPECT_EQ(row.largest_pressure, std::max(7., 5. + (n_ranks - 1.)));
    EXPECT_EQ(row.shear_strain, 0.2);
    EXPECT_EQ(row.speed, 2.);
    EXPECT_EQ(row.void_volume, n_ranks);
    EXPECT_TRUE(one->is_empty());
    one->add({{1., 2., 0.05, 3., 0.}});
    const RegionExtremes next = one->take().front();
    EXPECT_EQ(next.least_pressure, 1.);
    EXPECT_EQ(next.largest_pressure, 2.);
    EXPECT_EQ(next.void_volume, 0.);
    EXPECT_EQ(one->least_pressures().front(), -3. - (n_ranks - 1.));
    EXPECT_FALSE(one->is_least_last(0));
  }
}

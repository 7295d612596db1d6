// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/run/gas_checkpoint.h>

#include "gas_run.h"
#include <gtest/gtest.h>

#include <filesystem>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
using Lines = std::vector<std::string>;

const Lines single = {"Method/Precision=single"};
const Lines box = {"Domain/Coarse leaves=2, 2, 2",
                   "Domain/Periodic directions=z",
                   "Domain/Initial refinement=1"};
const Lines adaptive = {"Adaptation/Active=true",
                        "Adaptation/Largest level=3",
                        "Adaptation/Smallest level=1"};

std::vector<Lines> schemes()
{
  return {finite_volume(4),
          finite_volume(4) + products_in_air(),
          galerkin(1),
          galerkin(2) + products_in_air(),
          galerkin(3)};
}


/// A ball of high pressure off the middle, with hanging faces around it.
std::unique_ptr<GasRun<3>>
make_run(const Lines &lines, const MPI_Comm communicator = MPI_COMM_WORLD)
{
  auto run = std::make_unique<GasRun<3>>(box + lines, communicator);
  const Point<3> centre(0.4, 0.45, 0.5);
  run->refine([&](const Point<3> &p) { return p.distance(centre) < 0.3; });
  run->set_state(
    [&](const Point<3> &p) {
      const bool inside = p.distance(centre) < 0.2;
      GasState<3> state;
      state.density = inside ? 5. : 1.2;
      state.pressure = inside ? 1e7 : 1e5;
      state.products = inside ? 1. : 0.;
      return state;
    },
    true);
  return run;
}


/// Largest difference of any conserved quantity between the leaves of this
/// rank, relative to the largest value of that quantity.
double largest_difference(const GasRun<3> &a, const GasRun<3> &b)
{
  const unsigned int n = a.layout.n_points;
  double result = 0.;
  const auto all = b.leaves();
  std::vector<double> scale(a.layout.n_components, 0.);
  std::vector<double> difference(scale.size(), 0.);
  for (const auto &[name, values] : a.leaves())
  {
    EXPECT_TRUE(all.count(name)) << name;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      scale[i / n] = std::max(scale[i / n], std::abs(values[i]));
      difference[i / n] =
        std::max(difference[i / n], std::abs(values[i] - all.at(name)[i]));
    }
  }
  for (unsigned int c = 0; c < scale.size(); ++c)
    result = std::max(result, difference[c] / scale[c]);
  return result;
}


/// An empty folder for a checkpoint of this process, removed at the end.
class Folder
{
public:
  Folder()
    : path(std::filesystem::temp_directory_path() /
           ("contrecoup_single_precision_" + std::to_string(getpid())))
  {
    std::filesystem::remove_all(path);
    std::filesystem::create_directory(path);
  }
  ~Folder()
  {
    std::filesystem::remove_all(path);
  }
  const std::filesystem::path path;
};
} // namespace


TEST(SinglePrecision, HasTwiceTheLanes)
{
  EXPECT_EQ(make_run(finite_volume(2) + single)->mesh.width(), n_lanes<float>);
  EXPECT_EQ(make_run(finite_volume(2))->mesh.width(), n_lanes<double>);
}


TEST(SinglePrecision, AgreesWithDouble)
{
  // Limiters and troubled cells turn round-off into more than itself:
  // measured are 6e-7 with finite volumes and 6e-6 with Galerkin schemes.
  for (const Lines &method : schemes())
  {
    const auto fine = make_run(method);
    const auto coarse = make_run(method + single);
    EXPECT_LT(largest_difference(*fine, *coarse), 1.2e-7);
    for (unsigned int i = 0; i < 20; ++i)
    {
      EXPECT_EQ(fine->step().retries, coarse->step().retries);
      EXPECT_NEAR(coarse->time, fine->time, 1e-5 * fine->time);
    }
    const double difference = largest_difference(*fine, *coarse);
    EXPECT_GT(difference, 1e-12);
    EXPECT_LT(difference, 2e-5);
  }
}


TEST(SinglePrecision, ConservesToItsRoundOff)
{
  // Measured: 8e-9 at most.
  for (const Lines &method : schemes())
  {
    const auto run = make_run(method + single + adaptive);
    const auto before = run->totals();
    for (unsigned int i = 0; i < 20; ++i)
    {
      run->step();
      run->adapt();
    }
    const auto after = run->totals();
    for (const std::string name : {"mass", "energy"})
    {
      const double change = after.at(name) / before.at(name) - 1.;
      EXPECT_LT(std::abs(change), 5e-8);
    }
  }
}


TEST(SinglePrecision, RestStaysToTheLastBit)
{
  for (const Lines &method : schemes())
  {
    const auto run = make_run(method + single);
    run->set_state([](const Point<3> &) {
      GasState<3> state;
      state.density = 1.225;
      state.pressure = 101325.;
      return state;
    });
    const auto before = run->leaves();
    run->steps(20);
    EXPECT_EQ(run->leaves(), before);
  }
}


TEST(SinglePrecision, AnyNumberOfRanksGivesTheSame)
{
  for (const Lines &method : schemes())
  {
    const auto alone = make_run(method + single + adaptive, MPI_COMM_SELF);
    const auto together = make_run(method + single + adaptive);
    for (unsigned int i = 0; i < 6; ++i)
    {
      alone->step();
      together->step();
      EXPECT_EQ(alone->adapt(), together->adapt());
    }
    EXPECT_EQ(alone->time, together->time);
    const auto all = alone->leaves();
    for (const auto &[name, values] : together->leaves())
    {
      ASSERT_TRUE(all.count(name)) << name;
      EXPECT_EQ(values, all.at(name)) << name;
    }
  }
}


TEST(SinglePrecision, CheckpointsServeBothPrecisions)
{
  const Lines coarse_mesh = {box[0], box[1]};
  const auto restore = [&](const Lines &lines, const std::string &folder) {
    auto run = std::make_unique<GasRun<3>>(coarse_mesh + lines, MPI_COMM_SELF);
    restore_leaves(run->mesh, run->field, run->layout, folder);
    run->stepper->reinit(run->field);
    return run;
  };
  const Folder folder;
  const auto straight = make_run(finite_volume(4) + single, MPI_COMM_SELF);
  straight->steps(3);
  save_leaves(straight->mesh, straight->field, folder.path);
  const auto resumed = restore(finite_volume(4) + single, folder.path);
  const auto finer = restore(finite_volume(4), folder.path);
  EXPECT_EQ(resumed->leaves(), straight->leaves());
  EXPECT_EQ(finer->leaves(), straight->leaves());

  straight->steps(3);
  resumed->steps(3);
  finer->steps(3);
  EXPECT_EQ(resumed->leaves(), straight->leaves());
  EXPECT_LT(largest_difference(*finer, *straight), 1e-5);

  save_leaves(finer->mesh, finer->field, folder.path);
  const auto rounded = restore(finite_volume(4) + single, folder.path);
  EXPECT_LT(largest_difference(*finer, *rounded), 6e-8);
}


TEST(SinglePrecision, IsRefusedWhereItDoesNotExist)
{
  EXPECT_THROW(GasRun<2>(finite_volume(4) + single), InputError);
  EXPECT_THROW(GasRun<1>(finite_volume(4) + single), InputError);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/record/blast_map_transfer.h>
#include <contrecoup/gas/run/gas_checkpoint.h>
#include <contrecoup/gas/state/exposure_record.h>

#include "gas_run.h"
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
/// Follows @p overpressure in steps of @p step until @p end.
template <typename Number = double>
BlastMeasures follow(const std::function<double(double)> &overpressure,
                     const double end,
                     const double step)
{
  BlastRecord<Number> record;
  const auto n = static_cast<unsigned int>(std::lround(end / step));
  for (unsigned int i = 1; i <= n; ++i)
    record.add(overpressure(i * step), i * step, step, 100.);
  return record.measures(n * step);
}

/// Friedlander's wave of 1 s, 1 Pa and decay 2, from @p begin on.
double friedlander(const double begin, const double time)
{
  const double x = time - begin;
  return x < 0. ? 0. : (1. - x) * std::exp(-2. * x);
}

/// Its positive-phase impulse.
const double friedlander_impulse = 0.25 * (1. + std::exp(-2.));
} // namespace


TEST(BlastRecord, MeasuresFriedlandersWave)
{
  for (const double step : {1e-2, 1e-3})
  {
    const auto wave = [](const double t) {
      return 3e4 * friedlander(2.0003, t);
    };
    const auto seen = follow(wave, 5., step);
    EXPECT_NEAR(seen.peak, 3e4, 3e4 * 3. * step);
    EXPECT_NEAR(seen.arrival, 2.0003, step);
    EXPECT_NEAR(seen.duration, 1., step);
    EXPECT_NEAR(seen.impulse / 3e4, friedlander_impulse, 0.6 * step);
    // Halfway, what there is so far.
    const auto half = follow(wave, 2.5, step);
    EXPECT_NEAR(half.duration, 0.5, step);
    EXPECT_NEAR(half.impulse / 3e4, 0.25, 0.6 * step);
  }
}


TEST(BlastRecord, SmearedFrontsArriveInTheirMiddle)
{
  for (const double width : {0.01, 0.1})
  {
    const auto wave = [&](const double t) {
      return 5e4 * (1. + std::erf((t - 1.) / width));
    };
    const auto seen = follow(wave, 3., 1e-3);
    EXPECT_NEAR(seen.arrival, 1., 1e-3);
    EXPECT_NEAR(seen.peak, 1e5, 1.);
    EXPECT_NEAR(seen.duration, 2., 2e-3);
  }
}


TEST(BlastRecord, LaterPeaksProlongThePhaseOnlyIfLarger)
{
  const auto two = [](const double second) {
    return [second](const double t) {
      return 1e4 * (friedlander(1., t) + second * friedlander(3., t));
    };
  };
  const auto weaker = follow(two(0.8), 6., 1e-3);
  EXPECT_NEAR(weaker.arrival, 1., 1e-3);
  EXPECT_NEAR(weaker.duration, 1., 1e-3);
  EXPECT_NEAR(weaker.impulse / 1e4, friedlander_impulse, 1e-3);
  const auto stronger = follow(two(2.), 6., 1e-3);
  EXPECT_NEAR(stronger.arrival, 1., 1e-3);
  // The second peak stands on the first wave's negative tail, of which
  // little is left.
  EXPECT_NEAR(stronger.peak, 2e4 - 1e4 * std::exp(-4.), 60.);
  EXPECT_NEAR(stronger.duration, 3., 0.03);
  EXPECT_NEAR(stronger.impulse / 1e4, 3. * friedlander_impulse, 0.03);
}


TEST(BlastRecord, NoiseIsNoBlast)
{
  const auto seen = follow(
    [](const double t) {
      return t < 1. ? 90. * std::sin(50. * t) : 1e4 * friedlander(1., t);
    },
    3.,
    1e-3);
  EXPECT_NEAR(seen.arrival, 1., 2e-3);
  EXPECT_EQ(follow([](const double t) { return -1e3 * t; }, 1., 0.1).peak, 0.);
  EXPECT_EQ(follow([](const double) { return 99.; }, 1., 0.1).impulse, 0.);
}


TEST(BlastRecord, WhatNobodySawStaysUnknown)
{
  const double nan = std::nan("");
  BlastRecord<double> record = {nan, nan, nan, nan, nan};
  record.add(1e5, 1e-3, 1e-4, 100.);
  record.add(-1e5, 1.1e-3, 1e-4, 100.);
  for (const double value : recorded_map_values(record.measures(2e-3)))
    EXPECT_TRUE(std::isnan(value));
  // Nor is anything known where no blast has arrived.
  for (const double value :
       map_field_values(BlastRecord<double>().measures(2e-3), 2e-3))
    EXPECT_TRUE(std::isnan(value));
}


// In the precision of maps, too.
TEST(BlastMaps, MarkPhasesThatTheEndCuts)
{
  ASSERT_EQ(map_fields.size(), 5U);
  EXPECT_EQ(map_fields.back().first, "cut_off");
  BlastRecord<float> record;
  for (const auto &[pressure, time, mark] : {std::tuple{1e5F, 1.7e-3F, 1.},
                                             std::tuple{4e4F, 1.8e-3F, 1.},
                                             std::tuple{-1e3F, 1.9e-3F, 0.}})
  {
    record.add(pressure, time, 1e-4F, 100.F);
    const double now = double(time) * (1. + 1e-8);
    EXPECT_EQ(map_field_values(record.measures(now), now)[4], mark) << time;
  }
}


TEST(ExposureRecord, LastsLongerAmongProducts)
{
  // A phase of 40 us, another 0.1 ms after it has fallen below zero, and a last
  // one of no importance.
  const auto durations = [](const double products) {
    ExposureRecord record;
    for (unsigned int i = 1; i <= 30; ++i)
    {
      record.add_load(i <= 4    ? 5e6
                      : i <= 14 ? -5e4
                      : i <= 24 ? 1e6
                      : i <= 28 ? -5e4
                                : 5e3,
                      0.,
                      101325.,
                      products,
                      1e-5);
      EXPECT_EQ(record.presses_on(), i <= 4 || (i > 14 && i <= 24)) << i;
    }
    EXPECT_EQ(record.load, 5e6);
    EXPECT_NEAR(record.load_impulse, 300.1, 1e-9);
    return record.durations(4e-5);
  };
  EXPECT_EQ(durations(0.), std::pair(4e-5, 4e-5));
  const auto [least, largest] = durations(1.);
  EXPECT_NEAR(least, 24e-5, 1e-12);
  EXPECT_EQ(largest, least);
  // In a mixture with air, whose part of products is numerical, both are known.
  for (const double trace : {2e-4, 0.5})
    EXPECT_EQ(durations(trace), std::pair(4e-5, largest));
}


TEST(BlastRecord, SinglePrecisionIsEnough)
{
  const auto wave = [](const double t) {
    return 1e5 * friedlander(2., t / 1e-3);
  };
  const auto exact = follow(wave, 5e-3, 1e-7);
  const auto rounded = follow<float>(wave, 5e-3, 1e-7);
  EXPECT_NEAR(rounded.peak / exact.peak, 1., 1e-6);
  EXPECT_NEAR(rounded.impulse / exact.impulse, 1., 1e-4);
  EXPECT_NEAR(rounded.arrival / exact.arrival, 1., 1e-4);
  EXPECT_NEAR(rounded.duration / exact.duration, 1., 1e-4);
}


namespace
{
/// Records that differ from point to point, with none, open and closed ones.
template <int dim>
std::vector<float> some_records(const GasRun<dim> &run, const unsigned int seed)
{
  const unsigned int n = run.layout.n_points;
  std::vector<float> values(BlastRecord<float>::n_values * n);
  for (unsigned int q = 0; q < n; ++q)
  {
    const auto random = [&](const unsigned int i) {
      return static_cast<float>(1.5 + ripple(0.37 * q + 0.11 * i, seed + i));
    };
    if ((q + seed) % 5 == 4)
      continue; // nothing has arrived
    values[q] = random(0);
    values[q + n] = (q + seed) % 3 == 0 ? -random(1) : random(1);
    values[q + 2 * n] = random(2);
    values[q + 3 * n] = random(3);
    values[q + 4 * n] = (q + seed) % 2 == 0 ? 0.F : 5.F + random(4);
  }
  return values;
}


/// Halving repeats records: every child's point has one of the parent's.
template <int dim>
void check_halving(const GasRun<dim> &run)
{
  const unsigned int n = run.layout.n_points;
  const BlastMapTransfer<dim> transfer(run.points);
  const auto parent = some_records(run, 1);
  const auto halves = transfer.to_children(parent);
  ASSERT_EQ(halves.size(), 1U << dim);
  const float smallest = *std::min_element(parent.begin(), parent.begin() + n);
  const float largest = *std::max_element(parent.begin(), parent.begin() + n);
  float smallest_half = 1e9F, largest_half = -1e9F;
  for (const auto &child : halves)
    for (unsigned int q = 0; q < n; ++q)
    {
      smallest_half = std::min(smallest_half, child[q]);
      largest_half = std::max(largest_half, child[q]);
    }
  EXPECT_EQ(smallest_half, smallest);
  EXPECT_EQ(largest_half, largest);

  // Merging repeated records gives peaks that are no smaller anywhere, and
  // for nested points the same records.
  const auto again = transfer.from_children(halves);
  for (unsigned int q = 0; q < n; ++q)
    EXPECT_GE(again[q], parent[q]);
  if (!run.points.is_galerkin())
  {
    for (unsigned int q = 0; q < 2 * n; ++q)
      EXPECT_EQ(again[q], parent[q]);
  }
}


/// Merging keeps the largest peak, the earliest arrival, the mean impulse.
template <int dim>
void check_merging(const GasRun<dim> &run)
{
  const unsigned int n = run.layout.n_points;
  std::vector<std::vector<float>> children;
  double impulse = 0.;
  float largest = 0.F, earliest = 1e9F;
  for (unsigned int c = 0; c < (1U << dim); ++c)
  {
    children.push_back(some_records(run, 2 + c));
    for (unsigned int q = 0; q < n; ++q)
    {
      impulse +=
        run.points.relative_volume(q) / (1U << dim) * children[c][q + 2 * n];
      largest = std::max(largest, children[c][q]);
      if (children[c][q] > 0.F)
        earliest = std::min(earliest, std::abs(children[c][q + n]));
    }
  }
  const auto merged = BlastMapTransfer<dim>(run.points).from_children(children);
  double merged_impulse = 0.;
  float merged_earliest = 1e9F;
  for (unsigned int q = 0; q < n; ++q)
  {
    merged_impulse += run.points.relative_volume(q) * merged[q + 2 * n];
    if (merged[q] > 0.F)
      merged_earliest = std::min(merged_earliest, std::abs(merged[q + n]));
  }
  EXPECT_EQ(*std::max_element(merged.begin(), merged.begin() + n), largest);
  EXPECT_EQ(merged_earliest, earliest);
  EXPECT_NEAR(merged_impulse, impulse, 1e-6 * impulse);
}


template <int dim>
void check_transfer(const std::vector<std::string> &method)
{
  const GasRun<dim> run(method);
  check_halving(run);
  check_merging(run);
}
} // namespace


TEST(BlastMapTransfer, LosesNoPeak)
{
  check_transfer<2>(finite_volume(1));
  check_transfer<2>(finite_volume(8));
  check_transfer<3>(finite_volume(4));
  check_transfer<2>(galerkin(1));
  check_transfer<2>(galerkin(3));
  check_transfer<3>(galerkin(2));
}


namespace
{
const std::vector<std::string> explosion = {"Domain/Coarse leaves=2, 2, 2",
                                            "Domain/Initial refinement=1",
                                            "Initial state/Background/"
                                            "Pressure=1e5",
                                            "Adaptation/Active=true",
                                            "Adaptation/Smallest level=1",
                                            "Adaptation/Largest level=3"};

/// A hot ball off the middle of a cold gas.
template <int dim>
GasState<dim> hot_ball(const Point<dim> &p)
{
  Point<dim> centre;
  for (unsigned int d = 0; d < dim; ++d)
    centre[d] = 0.3 + 0.1 * d;
  GasState<dim> state;
  state.density = 1.2;
  state.pressure = p.distance(centre) < 0.2 ? 4e6 : 1e5;
  return state;
}


/// An explosion with maps on a mesh that follows it.
template <int dim>
class MappedRun
{
public:
  MappedRun(const std::vector<std::string> &method,
            const MPI_Comm communicator = MPI_COMM_WORLD)
    : run(explosion + method, communicator)
  {
    run.set_state(hot_ball<dim>);
    maps.mesh_changed(run.snapshot());
    maps.reinit(run.layout.n_points, run.mesh.n_owned());
  }

  /// Takes steps, adapting in every second one; @p check sees each change.
  void steps(const unsigned int n, const std::function<void()> &check)
  {
    for (unsigned int i = 0; i < n; ++i)
    {
      const auto result = run.step();
      ASSERT_FALSE(result.failed);
      maps.add_step(run.snapshot(result.step));
      if (i % 2 == 0)
        continue;
      run.stepper->update_ghosts(run.field);
      if (run.adaptation->adapt(run.field, maps))
      {
        run.stepper->reinit(run.field);
        check();
      }
    }
  }

  /// Largest peak in the square or cube of each of 4^dim parts of the domain.
  std::vector<double> peaks() const
  {
    std::vector<double> result(dealii::Utilities::pow(4, dim), 0.);
    for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    {
      const auto box = leaf_box(run.mesh, leaf);
      for (unsigned int q = 0; q < run.layout.n_points; ++q)
      {
        const auto place = run.place(box, q);
        unsigned int part = 0;
        for (unsigned int d = 0; d < dim; ++d)
          part = 4 * part + std::min(3, static_cast<int>(4. * place[d]));
        result[part] =
          std::max<double>(result[part], maps.record(leaf, q).peak);
      }
    }
    return result;
  }

  std::map<std::string, std::vector<float>> leaves() const
  {
    std::map<std::string, std::vector<float>> result;
    for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
      result[run.mesh.cell(leaf)->id().to_string()] = maps.leaf(leaf);
    return result;
  }

  GasRun<dim> run;
  BlastMaps<dim> maps;
};


/// Largest peaks anywhere never fall, and in finite volumes, whose leaves
/// are halves of the parts, nor do those of any part of the domain.
template <int dim>
void check_peaks(const std::vector<std::string> &method)
{
  MappedRun<dim> run(method, MPI_COMM_SELF);
  auto last = run.peaks();
  unsigned int n_changes = 0;
  run.steps(30, [&]() {
    ++n_changes;
    const auto now = run.peaks();
    EXPECT_GE(*std::max_element(now.begin(), now.end()),
              *std::max_element(last.begin(), last.end()));
    if (!run.run.points.is_galerkin())
    {
      for (unsigned int i = 0; i < now.size(); ++i)
        EXPECT_GE(now[i], last[i]) << i;
    }
    last = now;
  });
  EXPECT_GT(n_changes, 5U);
  EXPECT_GT(*std::max_element(last.begin(), last.end()), 1e6);
}


/// Ranks change no bit of the maps.
template <int dim>
void check_ranks(const std::vector<std::string> &method)
{
  MappedRun<dim> alone(method, MPI_COMM_SELF), together(method);
  alone.steps(12, []() {});
  together.steps(12, []() {});
  const auto all = alone.leaves();
  for (const auto &[name, values] : together.leaves())
  {
    ASSERT_TRUE(all.count(name)) << name;
    EXPECT_EQ(values, all.at(name)) << name;
  }
}
} // namespace


TEST(BlastMaps, PeaksNeverFall)
{
  check_peaks<2>(finite_volume(4));
  check_peaks<2>(galerkin(2));
  check_peaks<3>(finite_volume(4));
}


TEST(BlastMaps, RanksDoNotChangeABit)
{
  check_ranks<2>(finite_volume(8));
  check_ranks<2>(galerkin(3) + products_in_air());
  check_ranks<3>(finite_volume(4));
}


TEST(BlastMaps, CheckpointsHoldThem)
{
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const int id = dealii::Utilities::MPI::max(getpid(), MPI_COMM_WORLD);
  const std::string folder = (std::filesystem::temp_directory_path() /
                              ("contrecoup_maps_" + std::to_string(id)))
                               .string();
  if (rank == 0)
    std::filesystem::create_directory(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  MappedRun<2> run(finite_volume(4));
  run.steps(12, []() {});
  save_leaves(run.run.mesh, run.run.field, folder, &run.maps);
  MPI_Barrier(MPI_COMM_WORLD);
  for (const MPI_Comm communicator : {MPI_COMM_WORLD, MPI_COMM_SELF})
  {
    GasRun<2> other(finite_volume(4) + std::vector<std::string>{explosion[0]},
                    communicator);
    BlastMaps<2> maps;
    restore_leaves(other.mesh, other.field, other.layout, folder, &maps);
    const auto mine = run.leaves();
    unsigned int n_compared = 0;
    for (unsigned int leaf = 0; leaf < other.mesh.n_owned(); ++leaf)
    {
      const auto found = mine.find(other.mesh.cell(leaf)->id().to_string());
      if (found == mine.end())
        continue;
      EXPECT_EQ(maps.leaf(leaf), found->second);
      ++n_compared;
    }
    EXPECT_GT(n_compared, 0U);
    // Who does not want them need not take them.
    GasRun<2> without(finite_volume(4) + std::vector<std::string>{explosion[0]},
                      communicator);
    restore_leaves(without.mesh, without.field, without.layout, folder);
    EXPECT_EQ(without.mesh.n_owned(), other.mesh.n_owned());
  }
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank == 0)
    std::filesystem::remove_all(folder);
}

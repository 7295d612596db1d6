// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/hanging_openings.h>

#include "body_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;
using dealii::Tensor;

namespace
{
/// A ball in the unit box, whose leaves are smaller where x is large.
template <int dim>
Lines ball_of_two_sizes(const std::string &treatment)
{
  return {"Rigid body/Kind=body",
          "Rigid body/Treatment=" + treatment,
          "Rigid body/Finer region half/Levels=1",
          "Rigid body/Finer region half/Shape=box",
          "Rigid body/Finer region half/Lower corner=0.52, 0, 0",
          "Rigid body/Finer region half/Upper corner=1, 1, 1",
          "Body/Kind=shape",
          "Body/Shape/Shape=sphere",
          "Body/Shape/Size=0.213",
          std::string("Body/Shift=0.53, 0.48, ") + (dim == 3 ? "0.51" : "0"),
          "Domain/Initial refinement=" + std::to_string(dim == 3 ? 2 : 3)};
}


/// Hanging faces at which the surface meets leaves of two sizes.
template <int dim>
unsigned int n_cut_faces(const GasRun<dim> &run)
{
  unsigned int result = 0;
  for (unsigned int i = 0; i < run.mesh.hanging_faces().size(); ++i)
  {
    const auto &face = run.mesh.hanging_faces()[i];
    const auto is_cut = [&](const unsigned int leaf) {
      return leaf != no_leaf && run.cut_leaves.shape(leaf) != nullptr;
    };
    if (is_cut(face.coarse_leaf) &&
        std::any_of(face.fine_leaf.begin(), face.fine_leaf.end(), is_cut))
    {
      EXPECT_TRUE(run.cut_leaves.is_cut_face(i));
      ++result;
    }
  }
  return dealii::Utilities::MPI::sum(result, run.mesh.communicator());
}


/// check_conservation() where leaves of different size are cut.
template <int dim>
void check_sizes(const Lines &lines)
{
  GasRun<dim> run(lines);
  run.set_state([](const Point<dim> &) { return still_air<dim>(); });
  EXPECT_GT(n_cut_faces(run), 1u);
  check_conservation<dim>(lines);
}


/// Largest relative change of gas that flows along an oblique plane, while
/// cells without gas hold what must not leak out.
template <int dim>
double change_along_plane(const Lines &lines, const Tensor<1, dim> &velocity)
{
  GasRun<dim> run(
    lines +
    Lines{"Rigid body/Finer region half/Levels=1",
          "Rigid body/Finer region half/Shape=box",
          "Rigid body/Finer region half/Lower corner=0, 0.55, 0",
          "Rigid body/Finer region half/Upper corner=1, 1, 1",
          "Boundaries/x low=initial",
          "Boundaries/x high=initial",
          "Boundaries/y low=initial",
          "Boundaries/y high=initial",
          "Boundaries/z low=initial",
          "Boundaries/z high=initial",
          "Domain/Initial refinement=" + std::to_string(dim == 3 ? 2 : 3)});
  const GasState<dim> state = run.initial_state.value(Point<dim>());
  EXPECT_NEAR((state.velocity - velocity).norm(), 0., 1e-12);
  run.set_state([&](const Point<dim> &) { return state; });
  EXPECT_GT(n_cut_faces(run), 0u);
  auto other = still_air<dim>();
  other.pressure = 7.;
  const auto closed = conserved_state(other, run.material, dim + 2);
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
  {
    auto values = run.field.leaf(leaf);
    for (unsigned int q = 0; q < run.layout.n_points; ++q)
      for (unsigned int c = 0; c < dim + 2; ++c)
        if (run.field.open_fraction(leaf, q) == 0.)
          values[c * run.layout.n_points + q] = closed[c];
    run.field.set_leaf(leaf, values);
  }
  run.field.fill_padding(run.mesh.n_owned());
  run.stepper->reinit(run.field);
  run.steps(40);
  return largest_change(run, state);
}
} // namespace


TEST(BodyLevels, MassAndEnergyStay)
{
  for (const std::string treatment : {"embedded", "staircase"})
  {
    check_sizes<2>(ball_of_two_sizes<2>(treatment));
    check_sizes<2>(ball_of_two_sizes<2>(treatment) + products_in_air());
    check_sizes<3>(ball_of_two_sizes<3>(treatment) + finite_volume(4));
  }
}


TEST(BodyLevels, GasAtRestKeepsEveryBit)
{
  for (const std::string treatment : {"embedded", "staircase"})
    check_rest<3>(ball_of_two_sizes<3>(treatment) + finite_volume(4));
}


TEST(BodyLevels, FlowAlongObliquePlanesStays)
{
  check_oblique_planes(change_along_plane<2>);
}


TEST(BodyLevels, FlowAlongPlaneInSpaceStays)
{
  check_planes_in_space(change_along_plane<3>);
}


TEST(BodyLevels, RanksAgree)
{
  const auto is_driven = [](const Point<3> &p) {
    return p[0] + 0.3 * p[2] < 0.35;
  };
  for (const std::string treatment : {"embedded", "staircase"})
    check_ranks<3>(ball_of_two_sizes<3>(treatment) + finite_volume(4),
                   is_driven);
}


TEST(BodyLevels, CutFacesDoNotChangeTheMeansOfTheirGroup)
{
  GasRun<3> run(ball_of_two_sizes<3>("embedded") + finite_volume(4));
  run.set_state([](const Point<3> &) { return still_air<3>(); });
  unsigned int n_mixed = 0;
  HangingOpenings<3, double> openings;
  for (const auto &group : group_hanging_faces(run.mesh, run.layout))
  {
    openings.reinit(group, run.mesh, run.layout, run.cut_leaves);
    unsigned int n_cut = 0;
    for (unsigned int lane = 0; lane < group.n_filled; ++lane)
    {
      const bool is_cut = run.cut_leaves.is_cut_face(group.face[lane]);
      EXPECT_EQ(openings.is_cut[lane], is_cut ? 1. : 0.);
      n_cut += is_cut ? 1 : 0;
    }
    n_mixed += n_cut > 0 && n_cut < group.n_filled ? 1 : 0;
  }
  EXPECT_GT(dealii::Utilities::MPI::sum(n_mixed, MPI_COMM_WORLD), 0u);
}


TEST(BodyLevels, SmallCellsFindRoom)
{
  // The surface runs just above faces between leaves of two sizes, so that
  // small cells have their way out across these alone.
  GasRun<2> run({"Rigid body/Kind=half space",
                 "Rigid body/Half space/Rotation=0, 0, 90",
                 "Rigid body/Half space/Shift=0, 0.7502, 0",
                 "Rigid body/Finer region top/Levels=1",
                 "Rigid body/Finer region top/Shape=box",
                 "Rigid body/Finer region top/Lower corner=0, 0.76, 0",
                 "Rigid body/Finer region top/Upper corner=1, 1, 0",
                 "Domain/Initial refinement=2"});
  run.set_state([](const Point<2> &) { return still_air<2>(); });
  double least = 1.;
  std::size_t n_crossing = 0;
  for (const auto &neighborhood : run.cut_leaves.neighborhoods())
  {
    double volume = 0.;
    for (const auto &cell : neighborhood.cells)
    {
      volume += run.field.open_fraction(cell.leaf, cell.point) * cell.size;
      n_crossing += cell.size != 1. ? 1 : 0;
    }
    least = std::min(least, volume);
  }
  EXPECT_GE(dealii::Utilities::MPI::min(least, MPI_COMM_WORLD), 0.5);
  EXPECT_GT(dealii::Utilities::MPI::sum(n_crossing, MPI_COMM_WORLD), 0u);
}


TEST(BodyLevels, PocketsAreClosed)
{
  // A cylinder that touches a wall, with cusps finer than any cell.
  GasRun<2> run({"Rigid body/Kind=body",
                 "Rigid body/Finer region half/Levels=1",
                 "Rigid body/Finer region half/Shape=box",
                 "Rigid body/Finer region half/Lower corner=0.52, 0, 0",
                 "Rigid body/Finer region half/Upper corner=1, 1, 1",
                 "Body/Kind=shape",
                 "Body/Shape/Shape=cylinder",
                 "Body/Shape/Size=0.213, 1",
                 "Body/Shift=0.53, 0.213, 0",
                 "Domain/Initial refinement=3"});
  run.set_state([](const Point<2> &) { return still_air<2>(); });
  std::map<std::pair<unsigned int, unsigned int>, double> volumes;
  for (const auto &neighborhood : run.cut_leaves.neighborhoods())
  {
    double volume = 0.;
    for (const auto &cell : neighborhood.cells)
      volume += run.field.open_fraction(cell.leaf, cell.point) * cell.size;
    const auto &first = neighborhood.cells.front();
    volumes[{first.leaf, first.point}] = volume;
  }
  unsigned int n_small = 0;
  for_each_gas_point(
    run,
    [&](const unsigned int leaf,
        const unsigned int q,
        const Point<2> &place,
        const double part) {
      if (part >= 0.5)
        return;
      ++n_small;
      const auto found = volumes.find({leaf, q});
      EXPECT_GE(found == volumes.end() ? part : found->second, 0.25) << place;
    });
  EXPECT_GT(dealii::Utilities::MPI::sum(n_small, MPI_COMM_WORLD), 20u);
  // Closed surfaces: what all walls add up to is the strip of the bottom that
  // the body and the pockets cover.
  Tensor<1, 2> sum;
  for_each_gas_point(
    run,
    [&](
      const unsigned int leaf, const unsigned int q, const Point<2> &, double) {
      sum +=
        run.cut_leaves.wall({leaf, q}) * leaf_box(run.mesh, leaf).extents[0];
    });
  EXPECT_NEAR(dealii::Utilities::MPI::sum(sum[0], MPI_COMM_WORLD), 0., 1e-12);
}


namespace
{
/// Open parts of the subcells' volumes and faces, by the names of owned leaves.
template <int dim>
std::map<std::string, std::vector<double>>
openings(const GasRun<dim> &run, const CutLeaves<dim> &leaves)
{
  std::map<std::string, std::vector<double>> result;
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    if (const auto *shape = leaves.shape(leaf))
    {
      auto &values = result[run.mesh.cell(leaf)->id().to_string()];
      values = shape->fraction;
      for (const auto &faces : shape->opening)
        values.insert(values.end(), faces.begin(), faces.end());
    }
  return result;
}


/// A person, with narrow gaps between the legs and the arms and the trunk.
Lines person()
{
  return Lines{"Domain/Lower corner=-1.28, -2.56, 0",
               "Domain/Upper corner=3.84, 2.56, 3.84",
               "Domain/Coarse leaves=8, 8, 6",
               "Domain/Initial refinement=0",
               "Rigid body/Kind=body",
               "Rigid body/Levels=3",
               "Body/Kind=phantom",
               "Body/Rotation=0, 0, 90"} +
         finite_volume(4);
}
} // namespace


TEST(BodyLevels, PocketsDoNotDependOnFormerMeshesNorRanks)
{
  GasRun<3> run(person());
  GasRun<3> alone(person(), MPI_COMM_SELF);
  for (unsigned int change = 0; change < 3; ++change)
  {
    // Smaller leaves next to the body move the border between two ranks
    // through the gap between the thighs.
    const std::array<unsigned int, 4> n_rows = {{0, 0, 22, 24}};
    for (auto *each : {&run, &alone})
      for (unsigned int row = n_rows[change]; row < n_rows[change + 1]; ++row)
        each->refine([row](const Point<3> &p) {
          const double y = 0.64 * (row % 8) - 2.56, z = 3.2 - 0.64 * (row / 8);
          return p[0] > 0.64 && p[1] > y && p[1] < y + 0.64 && p[2] > z &&
                 p[2] < z + 0.64;
        });
    for (auto *each : {&run, &alone})
      each->set_state([](const Point<3> &) { return still_air<3>(); });
    CutLeaves<3> anew;
    anew.reinit(run.mesh, run.layout, run.body);
    const auto values = openings(run, run.cut_leaves);
    EXPECT_EQ(values, openings(run, anew)) << change;
    const auto all = openings(alone, alone.cut_leaves);
    for (const auto &[name, of_leaf] : values)
    {
      ASSERT_EQ(all.count(name), 1u) << name;
      EXPECT_EQ(of_leaf, all.at(name)) << change << ' ' << name;
    }
  }
}


TEST(BodyLevels, AdaptationKeepsMassAndTheSurface)
{
  GasRun<2> run(ball_of_two_sizes<2>("embedded") +
                Lines{"Adaptation/Active=true",
                      "Adaptation/Smallest level=2",
                      "Adaptation/Largest level=6"});
  run.set_state([](const Point<2> &p) {
    GasState<2> state = still_air<2>();
    if (p[0] + 0.2 * p[1] < 0.22)
      state.pressure = 20.;
    return state;
  });
  const auto surface = [&run]() {
    std::map<std::string, std::vector<double>> result;
    for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
      if (const auto *shape = run.cut_leaves.shape(leaf))
        result[run.mesh.cell(leaf)->id().to_string()] = shape->fraction;
    return result;
  };
  auto before = run.totals();
  const auto surface_before = surface();
  const bool is_alone =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
  unsigned int n_changes = 0;
  for (unsigned int i = 0; i < 40; ++i)
  {
    run.steps(2);
    n_changes += run.adapt() ? 1 : 0;
    if (is_alone)
    {
      ASSERT_EQ(surface(), surface_before);
    }
  }
  EXPECT_GT(n_changes, 5u);
  auto after = run.totals();
  for (const std::string name : {"mass", "energy"})
    EXPECT_NEAR(after[name], before[name], 1e-12 * before[name]) << name;
}


TEST(BodyLevels, FrontsInLeavesThatAreSmallForTheBodyAloneHaveLessBuffer)
{
  // Leaves at the body are of level 4 and, where x is large, 5; fronts may have
  // level 4, and 3 from 1 s on.
  const GasRun<2> run(ball_of_two_sizes<2>("embedded") +
                      Lines{"Rigid body/Levels=1",
                            "Rigid body/Finer region half/Levels=2",
                            "Adaptation/Active=true",
                            "Adaptation/Largest level=4",
                            "Adaptation/Limit later/From time=1",
                            "Adaptation/Limit later/Largest level=3"});
  std::array<unsigned int, 2> n_finer = {{0, 0}};
  for (const unsigned int later : {0U, 1U})
  {
    const auto ratios = run.adaptation->levels().size_ratios(later);
    ASSERT_EQ(ratios.size(), run.mesh.n_owned());
    for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    {
      const int finer = run.mesh.cell(leaf)->level() - (4 - int(later));
      EXPECT_EQ(ratios[leaf], finer > 0 ? std::pow(0.5, finer) : 1.);
      n_finer[later] += finer > 0 ? 1 : 0;
    }
  }
  for (unsigned int &n : n_finer)
    n = dealii::Utilities::MPI::sum(n, MPI_COMM_WORLD);
  EXPECT_GT(n_finer[0], 10u);
  EXPECT_GT(n_finer[1], n_finer[0]);
}


TEST(BodyLevels, SinglePrecisionAgreesWithDouble)
{
  for (const std::string treatment : {"embedded", "staircase"})
    for (const bool with_products : {false, true})
    {
      const Lines lines = ball_of_two_sizes<3>(treatment) + finite_volume(4) +
                          (with_products ? products_in_air() : Lines());
      GasRun<3> fine(lines);
      GasRun<3> coarse(lines + Lines{"Method/Precision=single"});
      const auto wave = [](const Point<3> &p) {
        GasState<3> state;
        const bool is_behind = p[0] + 0.3 * p[2] < 0.35;
        state.density = is_behind ? 5. : 1.2;
        state.pressure = is_behind ? 1e7 : 1e5;
        return state;
      };
      for (auto *run : {&fine, &coarse})
        run->set_state(wave);
      const auto before = coarse.totals();
      for (unsigned int i = 0; i < 30; ++i)
      {
        EXPECT_EQ(fine.step().retries, coarse.step().retries);
        EXPECT_NEAR(coarse.time, fine.time, 1e-5 * fine.time);
      }
      const auto after = coarse.totals();
      for (const std::string name : {"mass", "energy"})
        EXPECT_NEAR(after.at(name), before.at(name), 1e-6 * before.at(name));
      // Limiters turn round-off into more than itself.
      const auto all = coarse.leaves();
      const unsigned int n = fine.layout.n_points;
      std::vector<double> scale(fine.layout.n_components, 0.), error = scale;
      for (const auto &[name, values] : fine.leaves())
        for (std::size_t i = 0; i < values.size(); ++i)
        {
          scale[i / n] = std::max(scale[i / n], std::abs(values[i]));
          error[i / n] =
            std::max(error[i / n], std::abs(values[i] - all.at(name)[i]));
        }
      for (unsigned int c = 0; c < 5; ++c)
        EXPECT_LT(error[c], 2e-5 * scale[c]) << treatment << ' ' << c;
    }
}

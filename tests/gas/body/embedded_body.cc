// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors


#include "body_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;
using dealii::Tensor;

namespace
{
template <int dim>
Lines ball_in_box(const std::string &treatment)
{
  return {"Rigid body/Kind=body",
          "Rigid body/Treatment=" + treatment,
          "Body/Kind=shape",
          "Body/Shape/Shape=sphere",
          "Body/Shape/Size=0.213",
          std::string("Body/Shift=0.53, 0.48, ") + (dim == 3 ? "0.51" : "0"),
          "Domain/Initial refinement=2"};
}


/// Largest relative change of gas that flows along an oblique plane.
template <int dim>
double change_along_plane(const Lines &lines, const Tensor<1, dim> &velocity)
{
  GasRun<dim> run(lines + Lines{"Boundaries/x low=initial",
                                "Boundaries/x high=initial",
                                "Boundaries/y low=initial",
                                "Boundaries/y high=initial",
                                "Boundaries/z low=initial",
                                "Boundaries/z high=initial",
                                "Domain/Initial refinement=2"});
  GasState<dim> state = run.initial_state.value(Point<dim>());
  EXPECT_NEAR((state.velocity - velocity).norm(), 0., 1e-12);
  run.set_state([&](const Point<dim> &) { return state; });
  run.steps(40);
  return largest_change(run, state);
}


} // namespace


TEST(EmbeddedBody, MassAndEnergyStay)
{
  for (const std::string treatment : {"embedded", "staircase"})
  {
    check_conservation<2>(ball_in_box<2>(treatment));
    check_conservation<2>(ball_in_box<2>(treatment) + products_in_air());
    check_conservation<3>(ball_in_box<3>(treatment) + finite_volume(4));
  }
}


TEST(EmbeddedBody, GasAtRestKeepsEveryBit)
{
  for (const std::string treatment : {"embedded", "staircase"})
    check_rest<3>(ball_in_box<3>(treatment) + finite_volume(4));
}


TEST(EmbeddedBody, FlowAlongObliquePlanesStays)
{
  check_oblique_planes(change_along_plane<2>);
}


TEST(EmbeddedBody, FlowAlongPlaneInSpaceStays)
{
  check_planes_in_space(change_along_plane<3>);
}


TEST(EmbeddedBody, RanksAgree)
{
  const auto is_driven = [](const Point<3> &p) {
    return p[0] + 0.3 * p[2] < 0.35;
  };
  for (const std::string treatment : {"embedded", "staircase"})
    check_ranks<3>(ball_in_box<3>(treatment) + finite_volume(4), is_driven);
}


TEST(EmbeddedBody, VolumeAndSurfaceOfABall)
{
  for (const std::string treatment : {"embedded", "staircase"})
  {
    GasRun<3> run(ball_in_box<3>(treatment));
    run.set_state([](const Point<3> &) { return still_air<3>(); });
    const double edge = 1. / 4. / run.layout.n;
    double volume = 0., area = 0., projected = 0.;
    Tensor<1, 3> closed;
    for_each_gas_point(run,
                       [&](const unsigned int leaf,
                           const unsigned int q,
                           const Point<3> &,
                           const double part) {
                         const auto wall = run.cut_leaves.wall({leaf, q});
                         volume += part * edge * edge * edge;
                         area += wall.norm() * edge * edge;
                         for (unsigned int d = 0; d < 3; ++d)
                           projected += std::abs(wall[d]) * edge * edge;
                         closed += wall;
                       });
    std::vector<double> sums = {
      volume, area, projected, closed[0], closed[1], closed[2]};
    dealii::Utilities::MPI::sum(sums, MPI_COMM_WORLD, sums);
    const double radius = 0.213, pi = dealii::numbers::PI;
    // Between corners the distance is interpolated linearly along each axis,
    // which adds edge^2 / 12 times its Laplacian, 2 / radius, in the mean: the
    // facets' ball is smaller by that.
    const double shift = std::pow(edge / radius, 2) / 6.;
    const bool is_embedded = treatment == "embedded";
    EXPECT_NEAR((1. - sums[0]) / (4. / 3. * pi * std::pow(radius, 3)),
                is_embedded ? 1. - 3. * shift : 1.,
                is_embedded ? 1e-3 : 0.05);
    const double ball = 4. * pi * radius * radius;
    if (is_embedded)
    {
      EXPECT_NEAR(sums[1] / ball, 1. - 2. * shift, 2e-3);
    }
    // Along each axis a ball shows its disk on both sides.
    EXPECT_NEAR(sums[2] / ball, 1.5, is_embedded ? 0.02 : 0.05);
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(sums[3 + d], 0., 1e-10);
  }
}


TEST(EmbeddedBody, CellsHaveTheirVolume)
{
  for (const std::string precision : {"double", "single"})
  {
    // Leaves of two sizes, in batches of as many as the precision has lanes.
    GasRun<3> run(ball_in_box<3>("embedded") + finite_volume(4) +
                  Lines{"Method/Precision=" + precision});
    run.refine([](const Point<3> &p) { return p[0] > 0.5; });
    run.set_state([](const Point<3> &) { return still_air<3>(); });
    double volume = 0.;
    for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    {
      const double edge = run.mesh.cell(leaf)->extent_in_direction(0) / 4.;
      const double found = run.cut_leaves.cell_volume({leaf, 0});
      ASSERT_NEAR(found, edge * edge * edge, 1e-12 * found) << precision;
      volume += run.layout.n_points * found;
    }
    EXPECT_NEAR(dealii::Utilities::MPI::sum(volume, MPI_COMM_WORLD), 1., 1e-12);
  }
}


TEST(EmbeddedBody, AdaptationKeepsMassAndTheSurface)
{
  GasRun<2> run(ball_in_box<2>("embedded") +
                Lines{"Rigid body/Levels=1",
                      "Adaptation/Active=true",
                      "Adaptation/Smallest level=1",
                      "Adaptation/Largest level=4"});
  run.set_state([](const Point<2> &p) {
    GasState<2> state = still_air<2>();
    if (p[0] + 0.2 * p[1] < 0.22)
      state.pressure = 20.;
    return state;
  });
  auto before = run.totals();
  unsigned int n_changes = 0;
  for (unsigned int i = 0; i < 40; ++i)
  {
    run.steps(2);
    n_changes += run.adapt() ? 1 : 0;
    for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
      if (run.cut_leaves.shape(leaf) != nullptr)
      {
        ASSERT_EQ(run.mesh.cell(leaf)->level(), 3);
      }
  }
  EXPECT_GT(n_changes, 5u);
  auto after = run.totals();
  for (const std::string name : {"mass", "energy"})
    EXPECT_NEAR(after[name], before[name], 1e-12 * before[name]) << name;
}

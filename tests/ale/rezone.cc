// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/rezone/rezone.h>
#include <contrecoup/base/parameters/parameters.h>

#include "slab.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::ale;

namespace
{
constexpr unsigned int stride = node_width;
using Place = std::function<dealii::Point<3>(const dealii::Point<3> &)>;

/// A box of gas that is put somewhere, and moves in it; smoothed at times.
struct SmoothedSlab
{
  explicit SmoothedSlab(const Place &place, const bool smooth = true)
    : slab({8, 4, 3}, 1., {}, 0., place)
  {
    Slab straight({8, 4, 3}, 1.);
    const auto home = straight.space.positions(stride);
    for (std::size_t c = 0; c < slab.space.n_cells(); ++c)
    {
      const double x = straight.centre(c)[0];
      const double volume = hex_moments(slab.corners(c)).volume;
      slab.state.mass[c] = volume * (x < 0.4 ? 2. : 1.);
      slab.state.energy[c] = volume * (x < 0.4 ? 4. : 1.);
    }
    slab.step.start(slab.state);
    for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
    {
      const double *x = &home[stride * n];
      const dealii::Point<3> here(x[0], x[1], x[2]);
      const dealii::Point<3> ahead(x[0] + 1e-3 * std::sin(6. * x[1]) *
                                            std::cos(3. * x[0]),
                                   x[1] + 1e-3 * std::sin(4. * x[0] + x[2]),
                                   x[2] + 1e-3 * std::cos(5. * x[0]));
      const auto velocity = 300. * (place(ahead) - place(here));
      for (unsigned int d = 0; d < 3; ++d)
        slab.state.velocity[stride * n + d] = velocity[d];
    }
    slab.step.walls().apply(slab.state.velocity, 0.);
    ParameterHandler prm;
    Rezone::declare_parameters(prm);
    prm.enter_subsection("Rezone");
    prm.set("Kind", smooth ? "elastic" : "none");
    prm.set("Interval", "0.02");
    prm.set("Tolerance", "1e-12");
    prm.leave_subsection();
    rezone.parse_parameters(prm);
    Slab::Walls walls;
    for (unsigned int b = 0; b < 6; ++b)
      walls.emplace(b, [](double) { return 0.; });
    rezone.reinit(slab.space, slab.state, {Region()}, walls);
  }

  void run(const double end)
  {
    while (slab.state.time < end * (1. - 1e-12))
    {
      slab.step.advance(
        slab.state, std::min(end - slab.state.time, 2.5e-3), 0.3);
      rezone.apply(slab.state, slab.step.walls());
    }
  }

  Slab slab;
  Rezone rezone;
};

/// Half a turn and more about no axis of the mesh, and a shift.
dealii::Point<3> turned(const dealii::Point<3> &x)
{
  const dealii::Tensor<1, 3> axis({1. / 3., 2. / 3., 2. / 3.});
  constexpr double angle = 2.2;
  const dealii::Tensor<1, 3> along = (axis * x) * axis;
  const dealii::Tensor<1, 3> result =
    along + std::cos(angle) * (x - along) +
    std::sin(angle) * dealii::cross_product_3d(axis, x);
  return dealii::Point<3>(result) + dealii::Point<3>(0.3, -0.2, 0.1);
}

/// A wedge of 20 degrees without its edge, whose ends are normal to its middle.
dealii::Point<3> wedge(const dealii::Point<3> &x)
{
  const double slope = 0.35 * (x[1] - 0.25) / 0.5;
  return {x[0], slope * (0.3 + x[0]), x[2] * (1. + 0.1 * x[0])};
}

dealii::Point<3> straight(const dealii::Point<3> &x)
{
  return x;
}
} // namespace

// A box that is turned is smoothed like one along the axes: at its walls, at
// its edges, and at its corners.
TEST(Rezone, slides_along_inclined_walls_as_along_others)
{
  SmoothedSlab expected(straight), found(turned);
  expected.run(0.02);
  found.run(0.02);
  EXPECT_EQ(found.rezone.n_rezones(), 1U);
  for (std::size_t n = 0; n < found.slab.space.n_nodes(); ++n)
  {
    const double *x = &expected.slab.state.position[stride * n];
    const auto place = turned({x[0], x[1], x[2]});
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(found.slab.state.position[stride * n + d], place[d], 1e-11);
  }
  for (std::size_t c = 0; c < found.slab.space.n_locally_owned_cells(); ++c)
    EXPECT_NEAR(found.slab.state.mass[c], expected.slab.state.mass[c], 1e-11);
}

// Nodes at the walls leave the matter, but not the walls; nothing is lost.
TEST(Rezone, stays_in_the_walls_of_a_wedge)
{
  SmoothedSlab smoothed(wedge), lagrange(wedge, false);
  const Slab &slab = smoothed.slab;
  const auto start = slab.state.position;
  const auto before = slab.totals();
  smoothed.run(0.1);
  lagrange.run(0.1);
  const auto after = slab.totals();
  const double energy = before.internal_energy + before.kinetic_energy;
  EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
  EXPECT_NEAR(
    after.internal_energy + after.kinetic_energy, energy, 1e-13 * energy);
  double ahead = 0.;
  for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
  {
    const double *x = &start[stride * n];
    const double *now = &slab.state.position[stride * n];
    const double slope = x[1] / (0.3 + x[0]), rise = x[2] / (1. + 0.1 * x[0]);
    const bool on_side = std::abs(std::abs(slope) - 0.175) < 1e-9,
               on_top = std::abs(rise - 0.375) < 1e-9;
    if (on_side)
    {
      EXPECT_NEAR(now[1], slope * (0.3 + now[0]), 1e-15);
    }
    if (on_top)
    {
      EXPECT_NEAR(now[2], rise * (1. + 0.1 * now[0]), 1e-15);
    }
    if (on_side || on_top)
      ahead = std::max(
        ahead, std::abs(now[0] - lagrange.slab.state.position[stride * n]));
  }
  EXPECT_GT(dealii::Utilities::MPI::max(ahead, MPI_COMM_WORLD), 3e-3);
}

// A cell whose corner is beyond its neighbours cannot be mended while the nodes
// around are where the matter is.
TEST(Rezone, IsLeftOutWhereNoMotionGivesValidCells)
{
  SmoothedSlab box([](const dealii::Point<3> &x) { return x; });
  AleState &state = box.slab.state;
  state.time = 0.1;
  for (std::size_t n = 0; n < box.slab.space.n_nodes(); ++n)
  {
    // The corner of the box moves into it, beyond the adjacent nodes.
    double *x = &state.position[stride * n];
    if (std::abs(x[0]) + std::abs(x[1]) + std::abs(x[2]) < 1e-9)
      x[0] = 0.9;
  }
  const auto before = state.position;
  EXPECT_FALSE(box.rezone.apply(state, box.slab.step.walls()));
  EXPECT_EQ(box.rezone.n_skipped(), 1u);
  EXPECT_EQ(box.rezone.n_rezones(), 0u);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(state.position[i], before[i]);
}

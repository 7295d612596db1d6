// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/lagrange_step.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;
using namespace contrecoup::ale;

namespace
{

/// A box of a solid below a fluid, whose sides are walls, or free along x.
/// The solid is twice as dense.
struct TwoLayers
{
  using Velocity = dealii::Tensor<1, 3>;
  static constexpr unsigned int width = node_width;
  static constexpr double height = 0.02;

  TwoLayers(const bool slides,
            const bool is_free,
            const std::function<Velocity(bool, double)> &motion)
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh,
      {4, 2, 8},
      dealii::Point<3>(),
      dealii::Point<3>(0.5 * height, 0.25 * height, height),
      true);
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(cell->center()[2] > 0.5 * height ? 1 : 0);
    SolidMaterial solid;
    solid.density = 2000.;
    solid.bulk_modulus = 1e9 / 3.;
    solid.instantaneous_shear = 0.5e9;
    std::vector<Region> regions(2);
    regions[0].law = solid;
    regions[1].law = Tait(1000., 1e9, 7.15);
    regions[1].slides = slides;
    for (Region &region : regions)
      region.viscosity = {0., 0., 0.};
    space.reinit(mesh, MPI_COMM_WORLD, {false, slides});
    std::map<dealii::types::boundary_id, SlipWalls::Motion> walls;
    for (unsigned int b = is_free ? 2 : 0; b < 6; ++b)
      walls.emplace(b, [](double) { return 0.; });
    step.reinit(space, regions, walls, [](double) { return Velocity(); });
    state.position = space.positions(width);
    state.velocity.resize(state.position.size());
    state.mass.resize(space.n_cells());
    for (std::size_t c = 0; c < space.n_cells(); ++c)
      state.mass[c] =
        (space.region(c) == 1 ? 1000. : 2000.) * std::pow(height / 8., 3);
    state.energy.resize(space.n_cells());
    state.products.resize(space.n_cells());
    for (std::size_t c = 0; c < space.n_cells(); ++c)
      for (const std::uint32_t node : space.cell(c))
      {
        const Velocity v =
          motion(space.region(c) == 1, state.position[width * node + 2]);
        for (unsigned int d = 0; d < 3; ++d)
          state.velocity[width * node + d] = v[d];
      }
    step.start(state);
  }

  void run(const double end)
  {
    while (state.time < end * (1. - 1e-12))
      step.advance(state, end - state.time, 0.3);
  }

  double energy() const
  {
    const auto totals = step.totals(state);
    return totals.internal_energy + totals.kinetic_energy -
           step.external_work();
  }

  dealii::Triangulation<3> mesh;
  HexSpace space;
  LagrangeStep step;
  AleState state;
};
} // namespace

TEST(Slip, HasNodesOfBothSidesAtTheInterfaceAlone)
{
  const TwoLayers stuck(
    false, false, [](bool, double) { return TwoLayers::Velocity(); });
  const TwoLayers sliding(
    true, false, [](bool, double) { return TwoLayers::Velocity(); });
  EXPECT_EQ(stuck.space.nodes().size(), 5u * 3u * 9u);
  EXPECT_EQ(sliding.space.nodes().size(), 5u * 3u * 10u);
  EXPECT_TRUE(stuck.space.sliding_pairs().empty());
  for (const auto &[node, held] : sliding.space.sliding_pairs())
    for (unsigned int d = 0; d < 3; ++d)
    {
      EXPECT_EQ(sliding.state.position[TwoLayers::width * node + d],
                sliding.state.position[TwoLayers::width * held + d]);
      EXPECT_NEAR(sliding.state.position[TwoLayers::width * node + 2],
                  0.5 * TwoLayers::height,
                  1e-15);
    }
  for (std::size_t c = 0; c < sliding.space.n_cells(); ++c)
    for (const std::uint32_t node : sliding.space.cell(c))
      EXPECT_TRUE(!sliding.space.is_sliding(node) ||
                  sliding.space.region(c) == 1);
}

// A fluid that slides over a solid at rest keeps its velocity.
TEST(Slip, MeetsNoFriction)
{
  constexpr double speed = 3.;
  TwoLayers layers(true, true, [](const bool is_fluid, double) {
    return TwoLayers::Velocity({is_fluid ? speed : 0., 0., 0.});
  });
  layers.run(2e-4);
  for (std::size_t c = 0; c < layers.space.n_cells(); ++c)
    for (const std::uint32_t node : layers.space.cell(c))
    {
      const double *v = &layers.state.velocity[TwoLayers::width * node];
      EXPECT_NEAR(v[0], layers.space.region(c) == 1 ? speed : 0., 1e-10);
      EXPECT_NEAR(std::hypot(v[1], v[2]), 0., 1e-10);
    }
  EXPECT_NEAR(layers.step.largest_slip_speed(layers.state), speed, 1e-10);
  EXPECT_NEAR(layers.step.slip_work(), 0., 1e-13);
}

// Sound goes through the interface as through shared nodes.
TEST(Slip, PassesSoundOn)
{
  // At rest at the interface, which is at 10 mm.
  const auto motion = [](const bool is_fluid, const double z) {
    const double wave = std::sin(628.3185307179586 * z);
    return TwoLayers::Velocity({0., 0., is_fluid ? -wave * wave : 0.});
  };
  TwoLayers stuck(false, false, motion), sliding(true, false, motion);
  const double before = sliding.energy();
  stuck.run(1.5e-5);
  sliding.run(1.5e-5);
  double solid_speed = 0.;
  for (std::size_t c = 0; c < stuck.space.n_locally_owned_cells(); ++c)
    for (unsigned int i = 0; i < 8; ++i)
    {
      const double
        *v = &stuck.state.velocity[TwoLayers::width * stuck.space.cell(c)[i]],
        *w =
          &sliding.state.velocity[TwoLayers::width * sliding.space.cell(c)[i]];
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_NEAR(v[d], w[d], 1e-10);
      if (stuck.space.region(c) == 0)
        solid_speed = std::max(solid_speed, std::abs(w[2]));
    }
  EXPECT_GT(dealii::Utilities::MPI::max(solid_speed, MPI_COMM_WORLD), 0.2);
  EXPECT_NEAR(sliding.energy(), before, 1e-12 * before);
}

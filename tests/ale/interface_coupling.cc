// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;
using namespace contrecoup::ale;

namespace
{
Region elastic_part(const double density)
{
  SolidMaterial material;
  material.density = density;
  material.bulk_modulus = 2e9;
  material.instantaneous_shear = 1e9;
  Region region;
  region.law = material;
  region.viscosity = {0., 0., 0.};
  return region;
}

Region liquid()
{
  Region region;
  region.law = Tait(1000., 2.2e9);
  region.viscosity = {0., 0., 0.};
  return region;
}

/// Compressed liquid in the left half of a closed box of 2 cm, at rest, and two
/// solids next to each other in the right half.
struct LiquidOnSolid
{
  /// @param ratios of added mass at nodes of the one and the other solid
  LiquidOnSolid(const InterfaceCoupling &coupling,
                const double ratio,
                const double other_ratio)
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, {8, 2, 1}, dealii::Point<3>(), {0.02, 0.005, 0.0025}, true);
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(cell->center()[0] < 0.01     ? 0
                            : cell->center()[1] < 0.0025 ? 1
                                                         : 2);
    space.reinit(mesh, MPI_COMM_WORLD);
    std::map<dealii::types::boundary_id, SlipWalls::Motion> walls;
    for (unsigned int b = 0; b < 6; ++b)
      walls.emplace(b, [](double) { return 0.; });
    constexpr double density = 1001.;
    const std::array<double, 3> densities{
      {density, density / ratio, density / other_ratio}};
    step.reinit(
      space,
      {liquid(), elastic_part(densities[1]), elastic_part(densities[2])},
      walls,
      [](double) { return dealii::Tensor<1, 3>(); },
      {},
      coupling);
    state.position = space.positions(node_width);
    state.velocity.resize(state.position.size());
    state.mass.resize(space.n_cells());
    state.energy.resize(space.n_cells());
    state.products.resize(space.n_cells());
    for (std::size_t c = 0; c < space.n_cells(); ++c)
    {
      state.mass[c] = densities[space.region(c)] * std::pow(0.0025, 3);
      if (space.region(c) == 0)
        state.energy[c] =
          state.mass[c] * Tait(1000., 2.2e9).stored_energy(density);
    }
    step.start(state);
    energy = step.totals(state).internal_energy;
  }

  /// Velocity along x of the nodes at the interface, all ranks: the sum.
  double interface_velocity() const
  {
    double sum = 0.;
    for (std::size_t n = 0; n < space.n_locally_owned_nodes(); ++n)
      if (std::abs(space.positions(node_width)[node_width * n] - 0.01) < 1e-9)
        sum += state.velocity[node_width * n];
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }

  double run(const unsigned int n_steps, const double size)
  {
    for (unsigned int i = 0; i < n_steps; ++i)
      EXPECT_EQ(step.advance(state, size, 0.3), size);
    return interface_velocity();
  }

  dealii::Triangulation<3> mesh;
  HexSpace space;
  LagrangeStep step;
  AleState state;
  double energy; ///< at the start [J]
};

InterfaceCoupling coupling(const CouplingScheme scheme,
                           const double relaxation = 1.,
                           const double tolerance = 1e-10,
                           const unsigned int largest_iterations = 100)
{
  InterfaceCoupling result;
  result.set(scheme, relaxation, tolerance, largest_iterations);
  return result;
}

constexpr double step_size = 1e-7;
} // namespace

TEST(InterfaceCoupling, AgreesWithTheMonolithicSchemeWhenConverged)
{
  LiquidOnSolid all(coupling(CouplingScheme::monolithic), 3., 0.5),
    aitken(coupling(CouplingScheme::aitken, 0.3), 3., 0.5),
    fixed(coupling(CouplingScheme::fixed_relaxation, 0.4), 3., 0.5);
  const double expected = all.run(100, step_size);
  EXPECT_GT(std::abs(expected), 1.);
  EXPECT_NEAR(aitken.run(100, step_size), expected, 1e-8 * std::abs(expected));
  EXPECT_NEAR(fixed.run(100, step_size), expected, 1e-8 * std::abs(expected));
  const CouplingRecord record = aitken.step.coupling().record();
  EXPECT_NEAR(record.largest_ratio, 3., 1e-2);
  EXPECT_GE(record.largest_iterations, 3);
  EXPECT_LT(record.n_iterations,
            0.7 * fixed.step.coupling().record().n_iterations);
  EXPECT_EQ(record.n_steps, 100);
  EXPECT_LT(std::abs(record.work), 1e-9 * all.energy);
}

// From rest, the residual of iteration k is (1 - w (1 + r))^(k - 1) of the
// acceleration of the solid alone.
TEST(InterfaceCoupling, TakesTheIterationsOfItsContraction)
{
  constexpr double tolerance = 1e-9;
  for (const double ratio : {0.25, 0.8, 3., 9.})
    for (const double relaxation : {0.05, 0.17, 0.45, 0.9})
    {
      const double contraction = std::abs(1. - relaxation * (1. + ratio));
      LiquidOnSolid body(
        coupling(CouplingScheme::fixed_relaxation, relaxation, tolerance, 1000),
        ratio,
        ratio);
      if (contraction > 1.)
      {
        EXPECT_THROW(body.run(1, step_size), NumericsError);
        continue;
      }
      body.run(1, step_size);
      const auto expected = static_cast<std::uint64_t>(
        1. + std::ceil(std::log(tolerance) / std::log(contraction)));
      EXPECT_EQ(body.step.coupling().record().last_iterations, expected)
        << ratio << " " << relaxation;
    }
}

// With steps so small that forces stay, accelerations of the loose scheme are
// 1 - (-r)^n times those of both together.
TEST(InterfaceCoupling, GrowsWithTheRatioOfAddedMassWhenLoose)
{
  constexpr double size = 1e-12;
  constexpr unsigned int n_steps = 12;
  for (const double ratio : {0.5, 2.})
  {
    LiquidOnSolid all(coupling(CouplingScheme::monolithic), ratio, ratio),
      loose(coupling(CouplingScheme::loose), ratio, ratio);
    const double increment = all.run(1, size);
    double expected = 0.;
    for (unsigned int n = 1; n <= n_steps; ++n)
    {
      const double growth = std::pow(-ratio, n);
      expected += increment * (1. - growth);
      EXPECT_NEAR(loose.run(1, size),
                  expected,
                  1e-6 * increment * (1. + std::abs(growth)));
    }
    EXPECT_EQ(loose.step.coupling().record().n_iterations, n_steps);
  }
}

// Nothing from outside works on the closed box: what it gains was made up.
TEST(InterfaceCoupling, BooksTheEnergyThatALooseSchemeMakesUp)
{
  LiquidOnSolid loose(coupling(CouplingScheme::loose), 0.8, 0.4);
  loose.run(100, step_size);
  const auto totals = loose.step.totals(loose.state);
  const double gain =
    totals.internal_energy + totals.kinetic_energy - loose.energy;
  EXPECT_GT(std::abs(gain), 1e-6 * loose.energy);
  EXPECT_NEAR(loose.step.coupling().record().work, gain, 1e-13 * loose.energy);
  EXPECT_NEAR(loose.step.external_work(), 0., 1e-13 * loose.energy);
}

TEST(InterfaceCoupling, SaysThatFluidsAndSolidsDoNotAgreeAndKeepsTheState)
{
  LiquidOnSolid body(coupling(CouplingScheme::fixed_relaxation, 1.), 2., 2.);
  const auto before = body.state.position;
  try
  {
    body.run(1, step_size);
    FAIL();
  }
  catch (const NumericsError &error)
  {
    const std::string text = error.what();
    EXPECT_NE(text.find("do not agree after 100 iterations (fixed relaxation"),
              std::string::npos)
      << text;
    EXPECT_NE(text.find("must be below 0.667"), std::string::npos) << text;
  }
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(body.state.position[i], before[i]);
  EXPECT_EQ(body.step.coupling().record().n_steps, 0);
}

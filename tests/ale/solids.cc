// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>

#include <deal.II/base/mpi.h>

#include "solid_bar.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;
using namespace contrecoup::ale;

namespace
{
constexpr double pi = 3.14159265358979323846;

using Vector = SolidBar::Vector;

/// How far a standing wave is from its start after one period, over it.
double error_after_a_period(const unsigned int n)
{
  constexpr double amplitude = 1e-3;
  const auto exact = [](const dealii::Point<3> &x) {
    return Vector({amplitude * std::sin(pi * x[0]), 0., 0.});
  };
  SolidBar bar({n, 1, 1}, 1., {elastic_region(), {}, {}, {}}, exact);
  bar.run(2e-3);
  double largest = 0.;
  for (std::size_t node = 0; node < bar.space.n_nodes(); ++node)
    largest =
      std::max(largest, (bar.velocity(node) - exact(bar.place(node))).norm());
  return dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD) / amplitude;
}

/// Shears a cell at once and holds it.
void expect_relaxation(const double relaxation_time)
{
  SolidMaterial material;
  material.density = 1000.;
  material.bulk_modulus = 1e6;
  material.instantaneous_shear = 49e3;
  material.relaxing_shear = 33e3;
  material.relaxation_time = relaxation_time;
  Region region;
  region.law = material;
  region.kinematics = SolidKinematics::small_strain;
  SolidBar cube({2, 1, 1},
                2.,
                {region, {0, 1, 2, 3, 4, 5}, {}, {}},
                [](const dealii::Point<3> &) { return Vector(); });
  AleState &state = cube.state;
  for (std::size_t node = 0; node < cube.space.n_nodes(); ++node)
    state.position[node_width * node] +=
      1e-3 * state.position[node_width * node + 1];
  CornerForces forces;
  forces.reinit(cube.space, {region});
  dealii::AlignedVector<double> force(state.position.size());
  constexpr double step = 1e-3;
  for (unsigned int i = 0; i < 20; ++i)
  {
    force.fill(0.);
    forces.compute(state, step, force);
    // The shear stress acts on sides of 1 m^2, on each corner with a quarter.
    const double expected =
      0.25e-3 * material.relaxation_modulus((i + 0.5) * step);
    const auto nodes = cube.space.cell(0);
    double largest = 0.;
    for (const std::uint32_t node : nodes)
      if (state.position[node_width * node + 1] > 0.5)
        largest = std::max(largest,
                           std::abs(force[node_width * node] /
                                    cube.space.cells_around(node).size()));
    EXPECT_NEAR(largest, expected, 1e-9 * expected)
      << relaxation_time << " s, step " << i;
  }
}
} // namespace

// A bar of 1 m between walls, waves of 1000 m/s.
TEST(Solids, ReturnAfterThePeriodOfAStandingWave)
{
  const double coarse = error_after_a_period(8),
               fine = error_after_a_period(16);
  EXPECT_LT(fine, 1e-2);
  EXPECT_GT(std::log2(coarse / fine), 1.9);
}

TEST(Solids, KeepTheirEnergyWhateverTheyDo)
{
  SolidBar::Options options{elastic_region(), {0, 1, 2, 3, 4, 5}, {}, {}};
  options.region.viscosity = {0.06, 1.2, 0.1};
  SolidBar bar({4, 4, 4}, 1., options, [](const dealii::Point<3> &x) {
    return Vector({30. * x[1] * x[1], -20. * x[2] * x[0], 40. * x[0]});
  });
  const double before = bar.energy();
  bar.run(2e-3);
  EXPECT_GT(bar.step.totals(bar.state).internal_energy, 0.05 * before);
  EXPECT_NEAR(bar.energy(), before, 1e-13 * before);
}

// A cube that spins by half a turn is as it was, but for what centrifugal
// forces stretch.
TEST(Solids, SpinWithoutStress)
{
  constexpr double spin = 100.;
  const SolidBar::Options options{elastic_region(), {0, 1, 2, 3, 4, 5}, {}, {}};
  SolidBar cube({2, 2, 2}, 0.02, options, [](const dealii::Point<3> &x) {
    return Vector({-spin * (x[1] - 0.01), spin * (x[0] - 0.01), 0.});
  });
  const double kinetic = cube.step.totals(cube.state).kinetic_energy;
  cube.run(0.1 * pi / spin);
  const double angle = 0.1 * pi;
  for (std::size_t node = 0; node < cube.space.n_nodes(); ++node)
  {
    const auto start = cube.space.positions(node_width);
    const double *x = &start[node_width * node];
    const double dx = x[0] - 0.01, dy = x[1] - 0.01;
    const auto now = cube.place(node);
    EXPECT_NEAR(
      now[0], 0.01 + std::cos(angle) * dx - std::sin(angle) * dy, 1e-7);
    EXPECT_NEAR(
      now[1], 0.01 + std::sin(angle) * dx + std::cos(angle) * dy, 1e-7);
  }
  EXPECT_LT(cube.step.totals(cube.state).internal_energy, 1e-5 * kinetic);
}

// Vortices that shear to and fro in a box, omega^2 = 2 pi^2 G / rho: as slowly
// where the volume is a million times as stiff.
TEST(Solids, ShearAlikeWhateverTheirBulkModulus)
{
  constexpr double period = 2. / 1.41421356237309505;
  // On several ranks, waiting for each other would take most of the time.
  const bool alone =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
  for (const double bulk_modulus : {1., alone ? 1e6 : 10.})
  {
    SolidMaterial material;
    material.density = 1.;
    material.bulk_modulus = bulk_modulus;
    material.instantaneous_shear = 1.;
    SolidBar::Options options{elastic_region(), {}, {}, {}};
    options.region.law = material;
    SolidBar box({6, 6, 1}, 1., options, [](const dealii::Point<3> &x) {
      return 1e-4 * Vector({std::sin(pi * x[0]) * std::cos(pi * x[1]),
                            -std::cos(pi * x[0]) * std::sin(pi * x[1]),
                            0.});
    });
    const double before = box.energy();
    box.run(0.25 * period);
    const auto totals = box.step.totals(box.state);
    // At rest when a quarter of a period is over, but for 3.5 % of the
    // frequency with so few cells.
    EXPECT_LT(std::sqrt(totals.kinetic_energy / before), 0.0607)
      << bulk_modulus;
    EXPECT_NEAR(box.energy(), before, 1e-10 * before);
  }
}

// A cell that is sheared at once and held: its force goes with G(t), also where
// it relaxes within a step or at once.
TEST(Solids, RelaxAsTheirShearModulus)
{
  for (const double relaxation_time : {6e-3, 1e-12, 1e-300, 0.})
    expect_relaxation(relaxation_time);
}

// A bar of 1 m flies against a plane: it is pressed by rho c v for
// the time in which a wave goes through it and back, and leaves as it came, but
// for what the half cell at its end loses when it stops.
TEST(Contact, OfABarAgainstAPlaneIsThatOfAWave)
{
  std::vector<double> losses;
  for (const unsigned int n : {25, 50, 100})
  {
    SolidBar::Options options{elastic_region(), {0, 1}, {}, {}};
    options.region.viscosity = {0.06, 1.2, 0.};
    options.planes = {
      {"wall", dealii::Point<3>(-5e-5, 0., 0.), Vector({1., 0., 0.}), 0.}};
    SolidBar bar({n, 1, 1}, 1., options, [](const dealii::Point<3> &) {
      return Vector({-1., 0., 0.});
    });
    const double section = 1. / n / n;
    bar.run(1e-3);
    EXPECT_NEAR(bar.step.contact().force / section, 1e6, 1e4) << n;
    EXPECT_NEAR(bar.step.contact().area, section, 1e-12 * section);
    bar.run(3e-3);
    const auto totals = bar.step.totals(bar.state);
    const double energy = 0.5 * totals.mass;
    EXPECT_EQ(bar.step.contact().force, 0.);
    EXPECT_NEAR(bar.step.external_work(), bar.step.contact().work, 1e-12);
    EXPECT_NEAR(bar.energy(), energy, 1e-12 * energy);
    losses.push_back(-bar.step.contact().work / energy);
    // A shock leaves waves behind in the bar, by artificial viscosity heat.
    if (n == 100)
    {
      EXPECT_GT(totals.momentum[0] / totals.mass, 0.9757);
    }
  }
  EXPECT_NEAR(losses[0] / losses[1], 2., 0.1);
  EXPECT_NEAR(losses[1] / losses[2], 2., 0.1);
  EXPECT_LT(losses[2], 6e-3);
}

// A block slides along a plane on which it is pressed: v = v_0 - mu g t.
TEST(Contact, SlowsABlockByFriction)
{
  constexpr double friction = 0.3, gravity = 1000.;
  SolidBar::Options options{elastic_region(), {0, 1, 2, 3, 4, 5}, {}, {}};
  options.region.viscosity = {0.5, 2., 0.1};
  options.acceleration = Vector({0., 0., -gravity});
  options.planes = {
    {"floor", dealii::Point<3>(), Vector({0., 0., 1.}), friction}};
  SolidBar block({4, 4, 1}, 0.02, options, [](const dealii::Point<3> &) {
    return Vector({10., 0., 0.});
  });
  const double mass = block.step.totals(block.state).mass,
               before = block.energy();
  constexpr double time = 2e-3;
  block.run(time);
  const auto totals = block.step.totals(block.state);
  EXPECT_NEAR(totals.momentum[0] / mass, 10. - friction * gravity * time, 0.01);
  const auto contact = block.step.contact();
  EXPECT_LT(contact.friction_work, -0.3 * mass);
  EXPECT_NEAR(contact.friction_work,
              -friction * contact.sliding_work,
              1e-6 * contact.sliding_work);
  EXPECT_NEAR(block.energy(), before, 1e-12 * before);
}

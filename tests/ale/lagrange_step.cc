// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/base/system/exceptions.h>

#include "slab.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::ale;

// Both ends and all sides are walls: the total energy stays to round-off while
// a shock, a contact and a rarefaction go through the gas.
TEST(LagrangeStep, keeps_mass_and_energy_of_a_shock_tube)
{
  Slab slab({40, 1, 1}, 1.);
  slab.fill([](const dealii::Point<3> &x) {
    return x[0] < 0.5 ? SlabGas{1., 1.} : SlabGas{0.125, 0.1};
  });
  const auto before = slab.totals();
  slab.run(0.2);
  const auto after = slab.totals();
  EXPECT_NEAR(after.mass, before.mass, 1e-15 * before.mass);
  EXPECT_GT(after.kinetic_energy, 0.03 * before.internal_energy);
  EXPECT_NEAR(after.internal_energy + after.kinetic_energy,
              before.internal_energy,
              1e-13 * before.internal_energy);
}

TEST(LagrangeStep, converges_to_the_exact_shock_tube)
{
  std::vector<double> errors;
  for (const unsigned int n : {50, 100})
  {
    Slab slab({n, 1, 1}, 1.);
    slab.fill([](const dealii::Point<3> &x) {
      return x[0] < 0.5 ? SlabGas{1., 1.} : SlabGas{0.125, 0.1};
    });
    slab.run(0.2);
    errors.push_back(slab.sod_error(0.2));
  }
  EXPECT_LT(errors[1], 0.00613);
  EXPECT_GT(std::log2(errors[0] / errors[1]), 0.9);
}

// Gas that is pushed at constant speed: the wall does work, and the energy is
// that at the start plus this work.
TEST(LagrangeStep, books_the_work_of_moving_walls_and_body_forces)
{
  Slab slab({20, 1, 1}, 1., {{0, [](double) { return -0.5; }}}, 3.);
  slab.fill([](const dealii::Point<3> &) { return SlabGas{1., 0.1}; });
  const auto before = slab.totals();
  slab.run(0.3);
  const auto after = slab.totals();
  const double work = slab.step.external_work();
  EXPECT_GT(work, 9e-4);
  const double start = before.internal_energy + before.kinetic_energy;
  EXPECT_NEAR(after.internal_energy + after.kinetic_energy,
              start + work,
              1e-13 * (start + work));
}

// A wall runs into cold gas by two cells in a step, then by one: it is halved
// until it stays in the first cell.
TEST(LagrangeStep, halves_steps_that_would_invert_cells_and_counts_them)
{
  Slab slab({10, 1, 1}, 1., {{0, [](double) { return -1.; }}});
  slab.fill([](const dealii::Point<3> &) { return SlabGas{1., 1e-10}; });
  const double made = slab.step.advance(slab.state, 0.2, 100., 10);
  EXPECT_GE(slab.step.n_retries(), 1u);
  EXPECT_DOUBLE_EQ(made, std::ldexp(0.2, -int(slab.step.n_retries())));
  EXPECT_LT(made, 0.1);
  slab.step.advance(slab.state, 1e-6, 1., 10);
  EXPECT_EQ(slab.step.n_retries(), 0u);
}

TEST(LagrangeStep, names_the_cell_that_tangles_and_keeps_the_state)
{
  Slab slab({4, 1, 1}, 1.);
  slab.fill([](const dealii::Point<3> &) { return SlabGas{1., 1.}; });
  slab.state.energy[0] = std::numeric_limits<double>::quiet_NaN();
  const double x = slab.state.position[4];
  EXPECT_THROW(slab.step.advance(slab.state, 1e-3, 0.3, 2), NumericsError);
  EXPECT_EQ(slab.state.position[4], x);
  EXPECT_EQ(slab.state.time, 0.);
}

// A thousandth of an attosecond does not move a clock that shows 1 s.
TEST(LagrangeStep, names_the_cell_that_signals_cross_too_fast)
{
  Slab slab({4, 1, 1}, 1.);
  slab.fill([](const dealii::Point<3> &) { return SlabGas{1., 1.}; });
  slab.state.energy[0] = 1e40;
  slab.state.time = 1.;
  try
  {
    slab.step.advance(slab.state, 1e-3, 0.3);
    FAIL();
  }
  catch (const NumericsError &error)
  {
    const std::string text = error.what();
    const std::string cell =
      "cell " + std::to_string(slab.space.cell_number(0)) + " of";
    EXPECT_NE(text.find("time 1 s: a step of "), std::string::npos) << text;
    if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    {
      EXPECT_NE(text.find(cell), std::string::npos) << text;
    }
    for (const std::string words : {" m, of 0.01562 m^3, 1 kg/m^3, ",
                                    " Pa, corners at up to 0 m/s, is "
                                    "too short to go on"})
      EXPECT_NE(text.find(words), std::string::npos) << text;
  }
  EXPECT_EQ(slab.state.time, 1.);
}

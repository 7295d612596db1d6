// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/mesh/triangulation_hexes.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <deal.II/grid/grid_generator.h>

#include "bone_and_brain.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using dealii::Point;

namespace
{
/// A bar of 12 x 2 x 2 elements of 10 mm, lung and then brain, whose ends move
/// towards each other with @p speed.
template <typename Real>
void set_up(solid::SolidBody<Real> &body, const double speed)
{
  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::subdivided_hyper_rectangle(
    mesh, {12, 2, 2}, Point<3>(), Point<3>(0.12, 0.02, 0.02));
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(cell->center()[0] > 0.06 ? 1 : 0);
  solid::ElementOptions options;
  options.kinematics = SolidKinematics::finite_rotation;
  options.hourglass_damping = 0.05;
  body.reinit(
    to_hex_mesh(mesh, {{"lung", Tissue::lung}, {"brain", Tissue::brain}}),
    materials_of("physiological"),
    options,
    solid::Supports(),
    solid::SurfaceLoads(),
    MPI_COMM_WORLD);
  body.find_stable_step();
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
    body.nodes().velocity_of(i)[0] =
      Real(body.mesh().nodes[i][0] < 0.045 ? speed : -speed);
  body.start(0.);
}

/// Numbers of the state that steps depend on.
template <typename Real>
std::vector<double> state_of(const solid::SolidBody<Real> &body)
{
  std::vector<double> state{body.time(), body.energy_ledger().residual()};
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
    {
      state.push_back(body.nodes().displacement_of(i)[d]);
      state.push_back(body.nodes().velocity_of(i)[d]);
      state.push_back(body.nodes().force_of(i)[d]);
    }
  return state;
}

template <typename Real>
void check_step_back()
{
  solid::SolidBody<Real> body;
  set_up(body, 5.);
  for (unsigned int i = 0; i < 7; ++i)
    body.advance(2e-6);
  const auto before = state_of(body);
  try
  {
    body.advance(0.1, 2);
    FAIL() << "an element was turned inside out";
  }
  catch (const NumericsError &error)
  {
    const std::string what = error.what();
    for (const char *const part : {"1.4e-05 s although the step was reduced to "
                                   "0.025 s; element",
                                   " of lung at (0.0",
                                   "of its volume",
                                   "; before the step it had"})
      EXPECT_NE(what.find(part), std::string::npos) << what;
  }
  EXPECT_EQ(state_of(body), before);
  // The body continues as if nothing had happened.
  solid::SolidBody<Real> other;
  set_up(other, 5.);
  for (unsigned int i = 0; i < 7; ++i)
    other.advance(2e-6);
  for (unsigned int i = 0; i < 5; ++i)
  {
    body.advance(2e-6);
    other.advance(2e-6);
  }
  EXPECT_EQ(state_of(body), state_of(other));
}
} // namespace


TEST(UnphysicalSteps, AreTakenBackBitByBit)
{
  check_step_back<double>();
  check_step_back<float>();
}


TEST(UnphysicalSteps, AreHalvedUntilElementsKeepTheirVolume)
{
  solid::SolidBody<double> body;
  set_up(body, 100.);
  // An element between the halves would get 1 - 200 m/s step / 10 mm.
  const auto made = body.advance(3.2e-5);
  EXPECT_EQ(made.retries, 2U);
  EXPECT_EQ(made.step, 8e-6);
  EXPECT_EQ(body.time(), 8e-6);
  EXPECT_NEAR(body.least_volume(), 0.84, 1e-9);
}


TEST(UnphysicalSteps, GasStiffensTheStep)
{
  solid::SolidBody<double> body;
  set_up(body, 45.);
  const double at_rest = body.compressed_step();
  const double body_step = 1e-6;
  EXPECT_EQ(body.deformed_step(body_step), body_step);
  body.advance(2e-5);
  // s = -0.18 / 0.75 of the gas's volume, K by (1 + s)^-2.4.
  EXPECT_NEAR(body.compressed_step(),
              at_rest * std::pow(1. - 0.18 / 0.75, 1.2),
              1e-6 * at_rest);
  // That, and faces of 0.82 of their area on two of three sides.
  EXPECT_NEAR(body.deformed_step(1e-3),
              1e-3 * std::pow(1. - 0.18 / 0.75, 1.2) /
                std::sqrt((1. + 2. * 0.82 * 0.82) / 3.),
              0.02e-3);
}


// No step helps when numbers are none; then the body says so.
TEST(UnphysicalSteps, NumbersThatAreNoneAreFound)
{
  solid::SolidBody<double> body;
  set_up(body, 1.);
  body.nodes().velocity_of(3)[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(body.advance(1e-6), NumericsError);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include "bone_and_brain.h"
#include <gtest/gtest.h>

#include <filesystem>

using namespace contrecoup;
using dealii::Point;

namespace
{
/// A bar of 200 x 2 x 2 elements, the first of which may be refined; beyond
/// 0.1 m it is brain.
HexMesh long_bar(const bool refined)
{
  return bone_and_brain(
    {200, 2, 2},
    {2., 0.02, 0.02},
    [](const auto &x) { return x[0] > 0.1; },
    [&](const auto &x) { return refined && x[0] < 0.2; });
}

template <typename Real>
void set_up(solid::SolidBody<Real> &body,
            const HexMesh &mesh,
            const solid::ElementOptions &options,
            const MPI_Comm communicator)
{
  body.reinit(mesh,
              materials_of("paper"),
              options,
              solid::Supports(),
              solid::SurfaceLoads(),
              communicator);
}

/// A push that is neither uniform nor a rotation.
template <typename Real>
void push(solid::SolidBody<Real> &body)
{
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
  {
    const Point<3> &x = body.mesh().nodes[i];
    body.nodes().velocity_of(i)[0] = Real(std::sin(100. * x[0] + 40. * x[1]));
    body.nodes().velocity_of(i)[1] = Real(std::cos(90. * x[1] * x[2] / 0.04));
    body.nodes().velocity_of(i)[2] = Real(50. * x[0]);
  }
}

/// Displacements by node of the whole mesh, from all ranks.
template <typename Real>
std::vector<double> gather(const solid::SolidBody<Real> &body)
{
  std::vector<double> u(3 * body.mesh().n_global_nodes, 0.);
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
    if (body.mesh().owned[i] != 0)
      for (unsigned int d = 0; d < 3; ++d)
        u[3 * body.mesh().global_node[i] + d] =
          body.nodes().displacement_of(i)[d];
  dealii::Utilities::MPI::sum(u, body.communicator(), u);
  return u;
}

template <typename Real>
std::vector<double> run(const HexMesh &mesh,
                        const solid::ElementOptions &options,
                        const MPI_Comm communicator,
                        const unsigned int n_steps)
{
  solid::SolidBody<Real> body;
  set_up(body, mesh, options, communicator);
  const double step = 0.5 * body.find_stable_step().body_step;
  push(body);
  body.start(0.);
  for (unsigned int i = 0; i < n_steps; ++i)
    body.advance(step);
  return gather(body);
}

double largest(const std::vector<double> &a)
{
  double result = 0.;
  for (const double x : a)
    result = std::max(result, std::abs(x));
  return result;
}

double largest_difference(std::vector<double> a, const std::vector<double> &b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] -= b[i];
  return largest(a);
}
} // namespace


TEST(SolidBody, StepOfALoneCubeIsThatOfTheory)
{
  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::hyper_cube(mesh, 0., 0.01);
  solid::SolidBody<double> body;
  set_up(
    body, to_hex_mesh(mesh, {{"bone", Tissue::skeleton}}), {}, MPI_COMM_SELF);
  const auto stable_step = body.find_stable_step();
  // omega^2 = 12 K / (rho h^2).
  const double exact = 2. * 0.01 / std::sqrt(12. * 5e9 / (3. * 0.4) / 1100.);
  EXPECT_NEAR(stable_step.element_step, exact, 1e-10 * exact);
  EXPECT_NEAR(stable_step.body_step, exact, 3e-3 * exact);
  EXPECT_LE(stable_step.body_step, exact * (1. + 1e-9));
  EXPECT_EQ(stable_step.tissue, Tissue::skeleton);
}


TEST(SolidBody, AssembledStepIsLongerAndStable)
{
  solid::SolidBody<double> body;
  set_up(body, half_brain(true), {}, MPI_COMM_WORLD);
  const auto stable_step = body.find_stable_step();
  EXPECT_GT(stable_step.body_step, 1.05 * stable_step.element_step);
  solid::ElementOptions options;
  options.linear_viscosity = options.quadratic_viscosity = 0.;
  set_up(body, half_brain(true), options, MPI_COMM_WORLD);
  push(body);
  body.start(0.);
  for (unsigned int i = 0; i < 2000; ++i)
    body.advance(0.999 * stable_step.body_step);
  const auto ledger = body.energy_ledger();
  EXPECT_LT(std::abs(ledger.residual()), 1e-5 * ledger.initial);
  EXPECT_LT(ledger.sum.kinetic, 1.1 * ledger.initial);
}


TEST(SolidBody, EnergyClosesForAllKinematicsAndControls)
{
  for (const auto kinematics : {SolidKinematics::small_strain,
                                SolidKinematics::finite_rotation,
                                SolidKinematics::neo_hookean})
    for (const auto hourglass : {HourglassKind::stiffness,
                                 HourglassKind::viscous,
                                 HourglassKind::assumed_strain})
    {
      solid::ElementOptions options;
      options.kinematics = kinematics;
      options.hourglass = hourglass;
      solid::SolidBody<double> body;
      set_up(body, half_brain(true), options, MPI_COMM_WORLD);
      const double step = 0.3 * body.find_stable_step().body_step;
      push(body);
      body.start(0.);
      const auto before = body.momentum();
      for (unsigned int i = 0; i < 200; ++i)
        body.advance(step);
      const auto ledger = body.energy_ledger();
      const double tolerance = 1e-4 * ledger.initial;
      EXPECT_LT(std::abs(ledger.residual()), tolerance)
        << static_cast<int>(kinematics) << static_cast<int>(hourglass);
      EXPECT_NEAR(ledger.nodal_internal_work,
                  ledger.sum.internal() - ledger.step_change,
                  tolerance);
      EXPECT_GT(ledger.sum.stored, 0.01 * ledger.initial);
      EXPECT_LT((body.momentum() - before).norm(), 1e-12 * body.mass());
    }
}


TEST(SolidBody, DampersTakeWhatIsBooked)
{
  for (const auto kind : {HourglassKind::viscous, HourglassKind::stiffness})
  {
    solid::ElementOptions options;
    options.hourglass = kind;
    options.hourglass_damping = 0.1;
    solid::SolidBody<double> body;
    set_up(body, half_brain(true), options, MPI_COMM_WORLD);
    const double step = 0.7 * body.find_stable_step().body_step;
    push(body);
    body.start(0.);
    for (unsigned int i = 0; i < 400; ++i)
      body.advance(i < 200 ? step : 0.5 * step);
    const auto ledger = body.energy_ledger();
    EXPECT_LT(std::abs(ledger.residual()), 1e-6 * ledger.initial);
    EXPECT_GT(ledger.sum.hourglass_damping, 1e-3 * ledger.initial);
  }
}


TEST(SolidBody, SmoothingTakesWhatIsBooked)
{
  for (const auto kinematics :
       {SolidKinematics::small_strain, SolidKinematics::finite_rotation})
    for (const auto integration :
         {solid::Integration::one_point, solid::Integration::full})
    {
      solid::ElementOptions options;
      options.kinematics = kinematics;
      options.integration = integration;
      options.pressure_smoothing = 1.;
      options.linear_viscosity = 0.;
      options.quadratic_viscosity = 0.;
      solid::SolidBody<double> body;
      set_up(body, half_brain(true), options, MPI_COMM_WORLD);
      // As large as stability allows.
      const double step = 0.99 * body.find_stable_step().body_step;
      push(body);
      body.start(0.);
      const auto before = body.momentum();
      double least = 0.;
      for (unsigned int i = 0; i < 400; ++i)
      {
        body.advance(i < 200 ? step : 0.5 * step);
        least = std::min(least, body.energy_ledger().sum.pressure_smoothing);
      }
      const auto ledger = body.energy_ledger();
      EXPECT_LT(std::abs(ledger.residual()), 1e-4 * ledger.initial);
      EXPECT_GT(ledger.sum.pressure_smoothing, 1e-3 * ledger.initial);
      EXPECT_GT(least, -1e-3 * ledger.initial);
      EXPECT_LT((body.momentum() - before).norm(), 1e-12 * body.mass());
    }
}


TEST(SolidBody, RanksAgree)
{
  for (const bool refined : {false, true})
    for (const auto kinematics :
         {SolidKinematics::small_strain, SolidKinematics::finite_rotation})
    {
      solid::ElementOptions options;
      options.kinematics = kinematics;
      options.pressure_smoothing = refined ? 0.9 : 0.;
      const auto one =
        run<double>(half_brain(refined), options, MPI_COMM_SELF, 50);
      const auto all =
        run<double>(half_brain(refined), options, MPI_COMM_WORLD, 50);
      EXPECT_LT(largest_difference(one, all), 1e-11 * largest(one));
    }
}


TEST(SolidBody, FullIntegrationClosesItsEnergyOnAllRanks)
{
  for (const auto kinematics : {SolidKinematics::small_strain,
                                SolidKinematics::finite_rotation,
                                SolidKinematics::neo_hookean})
  {
    solid::ElementOptions options;
    options.integration = solid::Integration::full;
    options.kinematics = kinematics;
    solid::SolidBody<double> body;
    set_up(body, half_brain(true), options, MPI_COMM_WORLD);
    const double step = 0.3 * body.find_stable_step().body_step;
    push(body);
    body.start(0.);
    for (unsigned int i = 0; i < 200; ++i)
      body.advance(step);
    const auto ledger = body.energy_ledger();
    EXPECT_LT(std::abs(ledger.residual()), 1e-4 * ledger.initial);
    EXPECT_EQ(ledger.sum.hourglass, 0.);
    const auto one = run<double>(half_brain(true), options, MPI_COMM_SELF, 50);
    const auto all = run<double>(half_brain(true), options, MPI_COMM_WORLD, 50);
    EXPECT_LT(largest_difference(one, all), 1e-11 * largest(one));
  }
}


TEST(SolidBody, QuietElementsArePassedOverBitByBit)
{
  for (const auto integration :
       {solid::Integration::one_point, solid::Integration::full})
    for (const bool refined : {false, true})
    {
      std::vector<std::vector<double>> displacements;
      std::vector<double> quiet;
      for (const bool skip : {true, false})
      {
        solid::ElementOptions options;
        options.skip_quiet = skip;
        options.integration = integration;
        options.kinematics = SolidKinematics::finite_rotation;
        options.hourglass_damping = 0.1;
        options.pressure_smoothing = 0.9;
        solid::SolidBody<double> body;
        set_up(body, long_bar(refined), options, MPI_COMM_WORLD);
        const double step = 0.5 * body.find_stable_step().body_step;
        for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
          if (body.mesh().nodes[i][0] < 1e-9)
            body.nodes().velocity_of(i)[0] = 1.;
        body.start(0.);
        for (unsigned int i = 0; i < 40; ++i)
          body.advance(step);
        displacements.push_back(gather(body));
        displacements.back().push_back(body.energy_ledger().sum.stored);
        quiet.push_back(body.skipped_fraction());
      }
      EXPECT_EQ(displacements[0], displacements[1]);
      EXPECT_GT(quiet[0], 0.3);
      EXPECT_LT(quiet[0], 0.95);
      EXPECT_EQ(quiet[1], 0.);
    }
}


TEST(SolidBody, SinglePrecisionIsNearDouble)
{
  const auto exact = run<double>(half_brain(true), {}, MPI_COMM_WORLD, 100);
  const auto single = run<float>(half_brain(true), {}, MPI_COMM_WORLD, 100);
  EXPECT_LT(largest_difference(exact, single), 2e-4 * largest(exact));
  EXPECT_GT(largest_difference(exact, single), 0.);
}


/// Ten steps straight on, and from a checkpoint, which must agree.
void check_resume(const solid::ElementOptions &options)
{
  const std::string folder = "solid_checkpoint";
  std::filesystem::create_directories(folder);
  const HexMesh mesh = half_brain(true);
  solid::SolidBody<double> straight, stopped;
  set_up(straight, mesh, options, MPI_COMM_WORLD);
  const double step = 0.5 * straight.find_stable_step().body_step;
  push(straight);
  straight.start(0.);
  for (unsigned int i = 0; i < 10; ++i)
    straight.advance(step);
  straight.save(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  set_up(stopped, mesh, options, MPI_COMM_WORLD);
  stopped.restore(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  for (unsigned int i = 0; i < 10; ++i)
  {
    straight.advance(step);
    stopped.advance(step);
  }
  EXPECT_EQ(gather(straight), gather(stopped));
  EXPECT_NEAR(straight.energy_ledger().residual(),
              stopped.energy_ledger().residual(),
              1e-12 * straight.energy_ledger().initial);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::filesystem::remove_all(folder);
}


TEST(SolidBody, GoesOnFromACheckpointBitByBit)
{
  solid::ElementOptions options;
  options.hourglass_damping = 0.1;
  options.pressure_smoothing = 0.9;
  check_resume(options);
  options.integration = solid::Integration::full;
  check_resume(options);
}


TEST(SolidBody, InvertedElementIsNamed)
{
  HexMesh mesh = half_brain(false);
  std::swap(mesh.cells[5][0], mesh.cells[5][1]);
  solid::SolidBody<double> body;
  try
  {
    set_up(body, mesh, {}, MPI_COMM_SELF);
    FAIL() << "an inverted element passed";
  }
  catch (const InputError &error)
  {
    EXPECT_NE(std::string(error.what()).find("hexahedron 5"),
              std::string::npos);
  }
}


// Four facets meet in the middle of a side: their mean; what several loads put
// on one facet adds up there.
TEST(SurfaceLoads, PressureNearAPoint)
{
  dealii::ParameterHandler prm;
  solid::SurfaceLoads::declare_parameters(prm);
  const auto assign = [](const std::string &load,
                         const std::string &entry,
                         const std::string &value) {
    return Assignment{{"Loads", "Load " + load}, entry, value, "test"};
  };
  apply_assignments({assign("one", "Pressure", "1e5 * z"),
                     assign("two", "Pressure", "3000"),
                     assign("two", "Where", "x > 0.0599")},
                    prm);
  solid::SurfaceLoads loads;
  loads.parse_parameters(prm);
  solid::SolidBody<double> body;
  body.reinit(half_brain(false),
              materials_of("paper"),
              solid::ElementOptions(),
              solid::Supports(),
              loads,
              MPI_COMM_WORLD);
  body.start(0.);
  // Middles of facets are at y and z of 5, 15, 25, 35 mm.
  const auto pressure = [&](const double x, const double y, const double z) {
    return body.loads().pressure_near(Point<3>(x, y, z), MPI_COMM_WORLD);
  };
  EXPECT_NEAR(pressure(0., 0.02, 0.03), 3000., 1e-9);
  EXPECT_NEAR(pressure(0., 0.014, 0.024), 2500., 1e-9);
  EXPECT_NEAR(pressure(0.06, 0.02, 0.03), 6000., 1e-9);
  EXPECT_EQ(solid::SurfaceLoads().pressure_near(Point<3>(), MPI_COMM_WORLD),
            0.);
}

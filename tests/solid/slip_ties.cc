// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/solid/motion/solid_body.h>

#include "bone_and_brain.h"
#include <gtest/gtest.h>

#include <filesystem>

using namespace contrecoup;
using dealii::Point;

namespace
{
using Vector = dealii::Tensor<1, 3>;
using Solid = solid::SolidBody<double>;

constexpr double step = 5e-7;

/// The paper's, without relaxation, whose energy is integrated over steps.
std::vector<SolidMaterial> elastic_materials(const std::vector<Tissue> &tissues)
{
  auto materials = materials_of("paper")(tissues);
  for (SolidMaterial &material : materials)
    material.relaxing_shear = 0.;
  return materials;
}

/// Sets the velocity of all nodes of a tissue, on every rank, as a function of
/// their places.
template <typename Function>
void move(Solid &body, const Tissue tissue, const Function &velocity)
{
  std::vector<double> is_moved(body.mesh().nodes.size(), 0.);
  for (std::size_t i = 0; i < body.mesh().elements.size(); ++i)
    if (body.mesh().tissues[body.mesh().tissue[i]] == tissue)
      for (const std::uint32_t node : body.mesh().elements[i])
        is_moved[node] = 1.;
  body.exchange().add(is_moved.data(), 1, 1);
  for (std::size_t i = 0; i < is_moved.size(); ++i)
    if (is_moved[i] > 0.)
    {
      const Vector value = velocity(body.mesh().nodes[i]);
      for (unsigned int d = 0; d < 3; ++d)
        body.nodes().velocity_of(i)[d] = value[d];
    }
  body.start(0.);
}

/// A block of 6 x 4 x 4 elements of 10 mm whose upper half, brain, slides on
/// bone and moves with @p speed.
void set_up(Solid &body,
            const Vector &speed,
            const double least_pressure = -1e12,
            const SolidKinematics kinematics = SolidKinematics::small_strain,
            const MPI_Comm communicator = MPI_COMM_WORLD,
            const bool slips = true)
{
  solid::SlipTies slip;
  if (slips)
    slip.set({Tissue::brain}, {Tissue::skeleton}, least_pressure);
  body.set_slip(slip);
  solid::ElementOptions options;
  options.kinematics = kinematics;
  body.reinit(half_brain(false),
              elastic_materials,
              options,
              solid::Supports(),
              solid::SurfaceLoads(),
              communicator);
  move(body, Tissue::brain, [&](const Point<3> &) { return speed; });
}

/// Momentum of the elements of a tissue with an eighth of their mass at each
/// corner [N s].
Vector momentum(const Solid &body, const Tissue tissue)
{
  std::vector<double> sum(3, 0.);
  for (std::size_t i = 0; i < body.mesh().elements.size(); ++i)
  {
    const unsigned int number = body.mesh().tissue[i];
    if (body.mesh().tissues[number] != tissue)
      continue;
    const double mass = body.elements().materials()[number].density *
                        solid::cell_volume(body.mesh(), i);
    for (const std::uint32_t node : body.mesh().elements[i])
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += 0.125 * mass * body.nodes().velocity_of(node)[d];
  }
  dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD, sum);
  return Vector({sum[0], sum[1], sum[2]});
}

double measure(const Solid &body, const std::string &name)
{
  for (const NamedValue &value :
       body.slip().measures(body.nodes(), body.communicator()))
    if (value.name == name)
      return value.value;
  ADD_FAILURE() << name;
  return 0.;
}

/// Energy that is missing over the energy at the start.
double missing(const Solid &body)
{
  const solid::EnergyLedger ledger = body.energy_ledger();
  return ledger.residual() / ledger.initial;
}

void advance(Solid &body, const unsigned int n_steps)
{
  for (unsigned int i = 0; i < n_steps; ++i)
    body.advance(step);
}
} // namespace


TEST(SlipTies, BlocksThatSlideKeepTheirTangentialMomentum)
{
  for (const bool slips : {true, false})
  {
    Solid body;
    set_up(body,
           Vector({1., 0.5, 0.}),
           -1e12,
           SolidKinematics::small_strain,
           MPI_COMM_WORLD,
           slips);
    const Vector brain = momentum(body, Tissue::brain),
                 bone = momentum(body, Tissue::skeleton);
    advance(body, 400);
    const double change =
      (momentum(body, Tissue::brain) - brain).norm() / brain.norm();
    if (slips)
    {
      EXPECT_LT(change, 1e-12);
      EXPECT_LT(bone.norm(), 1e-15);
      EXPECT_LT(momentum(body, Tissue::skeleton).norm(), 1e-12 * brain.norm());
      EXPECT_EQ(measure(body, "slip_nodes"), 35.);
      EXPECT_NEAR(
        measure(body, "largest_slip"), std::sqrt(1.25) * 400. * step, 1e-12);
      EXPECT_LT(measure(body, "largest_opening"), 1e-15);
    }
    else
      EXPECT_GT(change, 0.1);
    EXPECT_LT(std::abs(missing(body)), 1e-12);
  }
}


TEST(SlipTies, BlocksThatMeetShareTheirNormalMotion)
{
  Solid slip, tied;
  const Vector down({0., 0., -1.});
  set_up(slip, down);
  set_up(
    tied, down, -1e12, SolidKinematics::small_strain, MPI_COMM_WORLD, false);
  const Vector total = slip.momentum();
  advance(slip, 200);
  advance(tied, 200);
  EXPECT_LT((slip.momentum() - total).norm(), 1e-12 * total.norm());
  // Bone has taken over momentum, nearly as much as with common nodes.
  const double given = momentum(slip, Tissue::skeleton)[2] / total[2];
  EXPECT_GT(given, 0.2);
  EXPECT_NEAR(
    given, momentum(tied, Tissue::skeleton)[2] / tied.momentum()[2], 0.1);
  EXPECT_LT(std::abs(measure(slip, "largest_opening")), 1e-15);
  EXPECT_GT(measure(slip, "largest_slip"), 1e-6);
  EXPECT_LT(std::abs(missing(slip)), 1e-12);
  // The normal is constant, so the interface takes the energy of the first
  // half step alone, in which both sides came together.
  const double first = slip.energy_ledger().interface_work;
  advance(slip, 100);
  EXPECT_NEAR(slip.energy_ledger().interface_work,
              first,
              1e-12 * slip.energy_ledger().initial);
}


TEST(SlipTies, InterfaceOpensBelowTheLeastPressureAndClosesAgain)
{
  Solid body;
  constexpr double tension = 1e5, area = 0.06 * 0.04;
  set_up(body, Vector({0., 0., 0.2}), -tension);
  const Vector total = body.momentum();
  const double before = momentum(body, Tissue::brain)[2];
  advance(body, 40);
  EXPECT_GT(measure(body, "largest_opening"), 1e-7);
  // The least pressure pulls on either side.
  EXPECT_NEAR(momentum(body, Tissue::brain)[2] - before,
              -tension * area * (40. - 0.5) * step,
              0.05 * tension * area * 40. * step);
  EXPECT_LT(std::abs(missing(body)), 1e-12);
  advance(body, 1500);
  EXPECT_LT(measure(body, "largest_opening"), 1e-7);
  EXPECT_LT((body.momentum() - total).norm(), 1e-11 * total.norm());
  EXPECT_LT(std::abs(missing(body)), 1e-11);
  EXPECT_LE(body.energy_ledger().interface_work, 0.);
}


TEST(SlipTies, RotationIsNotResisted)
{
  // About y by 0.06 rad in 1 ms, while brain slides by 1 mm.
  Solid body;
  set_up(body, Vector({1., 0., 0.}), -1e12, SolidKinematics::finite_rotation);
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
  {
    body.nodes().velocity_of(i)[0] += 60. * body.mesh().nodes[i][2];
    body.nodes().velocity_of(i)[2] -= 60. * body.mesh().nodes[i][0];
  }
  body.start(0.);
  const Vector total = body.momentum();
  const double kinetic = body.energy_ledger().sum.kinetic;
  advance(body, 2000);
  EXPECT_LT((body.momentum() - total).norm(), 1e-10 * total.norm());
  EXPECT_NEAR(body.energy_ledger().sum.kinetic, kinetic, 0.01 * kinetic);
  EXPECT_LT(std::abs(body.energy_ledger().interface_work), 1e-5 * kinetic);
  EXPECT_NEAR(measure(body, "largest_slip"), 1e-3, 1e-4);
  EXPECT_LT(measure(body, "largest_opening"), 1e-15);
  EXPECT_LT(std::abs(missing(body)), 1e-6);
}


TEST(SlipTies, ShellTurnsAroundWhatItContains)
{
  // Bone of 60 to 80 mm around brain of 40 to 60 mm turns by 0.08 rad.
  dealii::Triangulation<3> shells;
  dealii::GridGenerator::hyper_shell(shells, Point<3>(), 0.04, 0.08, 6);
  shells.refine_global(2);
  for (const auto &cell : shells.active_cell_iterators())
    cell->set_material_id(cell->center().norm() > 0.06 ? 0 : 1);
  const HexMesh mesh =
    to_hex_mesh(shells, {{"bone", Tissue::skeleton}, {"brain", Tissue::brain}});
  for (const bool slips : {true, false})
  {
    Solid body;
    solid::SlipTies slip;
    if (slips)
      slip.set({Tissue::skeleton}, {Tissue::brain}, -1e12);
    body.set_slip(slip);
    solid::ElementOptions options;
    options.kinematics = SolidKinematics::finite_rotation;
    body.reinit(mesh,
                elastic_materials,
                options,
                solid::Supports(),
                solid::SurfaceLoads(),
                MPI_COMM_WORLD);
    move(body, Tissue::skeleton, [](const Point<3> &x) {
      return Vector({-20. * x[1], 20. * x[0], 0.});
    });
    const double kinetic = body.energy_ledger().sum.kinetic;
    for (unsigned int i = 0; i < 4000; ++i)
      body.advance(1e-6);
    const solid::EnergyLedger ledger = body.energy_ledger();
    const double bone = ledger.tissues[0].kinetic / kinetic,
                 brain = ledger.tissues[1].kinetic / kinetic;
    if (slips)
    {
      EXPECT_GT(bone, 0.9995);
      EXPECT_LT(brain, 1e-4);
    }
    else
      EXPECT_LT(bone, 0.6);
    EXPECT_LT(std::abs(ledger.interface_work), 1e-8 * kinetic);
    EXPECT_LT(std::abs(missing(body)), 1e-8);
  }
}


TEST(SlipTies, ResultsDoNotDependOnRanksAndContinueFromCheckpoints)
{
  const Vector speed({1., 0., -0.3});
  Solid alone, all, resumed;
  set_up(alone, speed, -1e5, SolidKinematics::finite_rotation, MPI_COMM_SELF);
  set_up(all, speed, -1e5, SolidKinematics::finite_rotation);
  advance(alone, 60);
  advance(all, 60);
  const unsigned int n_ranks =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const std::string folder = "slip_ties_checkpoint_" + std::to_string(n_ranks);
  std::filesystem::create_directories(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  all.save(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  set_up(resumed, Vector(), -1e5, SolidKinematics::finite_rotation);
  resumed.restore(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::filesystem::remove_all(folder);
  advance(alone, 60);
  advance(all, 60);
  advance(resumed, 60);
  EXPECT_NEAR(measure(all, "largest_slip"),
              measure(alone, "largest_slip"),
              1e-9 * measure(alone, "largest_slip"));
  EXPECT_EQ(measure(resumed, "largest_slip"), measure(all, "largest_slip"));
  EXPECT_NEAR(all.energy_ledger().interface_work,
              alone.energy_ledger().interface_work,
              1e-9 * alone.energy_ledger().initial);
  EXPECT_NEAR(resumed.energy_ledger().interface_work,
              all.energy_ledger().interface_work,
              1e-14 * all.energy_ledger().initial);
  EXPECT_LT(std::abs(missing(resumed)), 1e-8);
}


TEST(SlipTies, MeshesWithoutSuchAnInterfaceAreRefused)
{
  const auto refusal = [](HexMesh mesh, const Tissue held) {
    try
    {
      solid::split_interface(mesh, {Tissue::brain}, {held}, "Interface");
    }
    catch (const InputError &error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(half_brain(false), Tissue::skeleton), "");
  EXPECT_NE(refusal(half_brain(false), Tissue::lung).find("share no face"),
            std::string::npos);
  EXPECT_NE(refusal(half_brain(true), Tissue::skeleton)
              .find("elements of different size meet"),
            std::string::npos);
}

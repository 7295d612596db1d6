// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/record/cavity_record.h>

#include "bone_and_brain.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

using namespace contrecoup;

namespace
{
/// Bone, and brain that cavitates at 50 kPa.
std::vector<SolidMaterial> cavitating(const std::vector<Tissue> &tissues)
{
  std::vector<SolidMaterial> materials = materials_of("paper")(tissues);
  for (std::size_t i = 0; i < tissues.size(); ++i)
    if (tissues[i] == Tissue::brain)
      materials[i].largest_tension = 50e3;
  return materials;
}

/// A block that is pulled apart and meets again.
struct Block
{
  explicit Block(const solid::ElementOptions &options,
                 const MPI_Comm communicator)
  {
    body.reinit(half_brain(true),
                cavitating,
                options,
                solid::Supports(),
                solid::SurfaceLoads(),
                communicator);
    step = 0.3 * body.find_stable_step().body_step;
    cavities.reinit(body);
  }

  void push()
  {
    for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
        body.nodes().velocity_of(i)[d] =
          0.3 * std::sin(80. * body.mesh().nodes[i][d]);
    body.start(0.);
  }

  void go(const unsigned int n_steps)
  {
    for (unsigned int i = 0; i < n_steps; ++i)
    {
      body.advance(step);
      cavities.record(body);
    }
  }

  /// Results of all ranks.
  std::vector<double> values() const
  {
    std::vector<double> list;
    for (const NamedValue &one : cavities.history(body))
      list.push_back(one.value);
    for (const NamedValue &one : cavities.results(body))
      list.push_back(one.value);
    return list;
  }

  solid::SolidBody<double> body;
  solid::CavityRecord<double> cavities;
  double step = 0.;
};

solid::ElementOptions finite(const solid::Integration integration)
{
  solid::ElementOptions options;
  options.kinematics = SolidKinematics::finite_rotation;
  options.integration = integration;
  return options;
}
} // namespace


TEST(Cavitation, ClosesTheEnergyAndRanksAgree)
{
  for (const auto integration :
       {solid::Integration::one_point, solid::Integration::full})
  {
    Block all(finite(integration), MPI_COMM_WORLD),
      one(finite(integration), MPI_COMM_SELF);
    ASSERT_FALSE(all.cavities.results(all.body).empty());
    all.push();
    one.push();
    all.go(300);
    one.go(300);
    const auto ledger = all.body.energy_ledger();
    EXPECT_LT(std::abs(ledger.residual()), 1e-3 * ledger.initial);
    const std::vector<double> expected = one.values(), found = all.values();
    ASSERT_EQ(expected.size(), found.size());
    // Cavities are open at the end.
    ASSERT_EQ(expected.size(), 1u + 7u + 1u);
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-6 * std::abs(expected[i])) << i;
    EXPECT_GT(found[1], 0.);  // largest volume
    EXPECT_GT(found[3], 1e3); // pressure after a cavity
  }
}


TEST(Cavitation, HasLowerLimitsWhileCavitiesAreOpen)
{
  Block block(finite(solid::Integration::one_point), MPI_COMM_WORLD);
  const auto value_of = [&](const std::string &name) {
    const std::vector<NamedValue> list = block.cavities.results(block.body);
    const auto found =
      std::find_if(list.begin(), list.end(), [&](const NamedValue &one) {
        return one.name == name;
      });
    return found == list.end() ? 0. : found->value;
  };
  const std::string volume = "largest_vapour_volume_brain",
                    pressure = "collapse_pressure_brain", cut = "_cut_off";
  EXPECT_EQ(value_of(volume + cut) + value_of(pressure + cut), 0.);
  block.push();
  block.go(1);
  for (unsigned int i = 0; i < 100 && value_of(volume) == 0.; ++i)
    block.go(1);
  EXPECT_EQ(value_of(volume + cut), 1.);
  EXPECT_EQ(value_of(pressure + cut), 1.);
  for (unsigned int i = 0; i < 300 && value_of(volume + cut) > 0.; ++i)
    block.go(1);
  EXPECT_EQ(value_of(volume + cut), 0.);
  EXPECT_EQ(value_of(pressure + cut), 1.);
}


TEST(Cavitation, GoesOnFromACheckpoint)
{
  const std::string folder = "cavity_checkpoint";
  std::filesystem::create_directories(folder);
  Block straight(finite(solid::Integration::one_point), MPI_COMM_WORLD),
    stopped(finite(solid::Integration::one_point), MPI_COMM_WORLD);
  straight.push();
  straight.go(100);
  straight.body.save(folder);
  straight.cavities.save(straight.body, folder);
  MPI_Barrier(MPI_COMM_WORLD);
  stopped.body.restore(folder);
  stopped.cavities.restore(stopped.body, folder);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(straight.values(), stopped.values());
  straight.go(100);
  stopped.go(100);
  EXPECT_EQ(straight.values(), stopped.values());
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::filesystem::remove_all(folder);
}


TEST(Cavitation, NothingIsRecordedOfMatterThatBearsTension)
{
  solid::SolidBody<double> body;
  make_half_brain(body);
  solid::CavityRecord<double> cavities;
  cavities.reinit(body);
  EXPECT_TRUE(cavities.history(body).empty());
  EXPECT_TRUE(cavities.results(body).empty());
}

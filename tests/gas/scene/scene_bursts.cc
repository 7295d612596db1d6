// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/run/time_parameters.h>
#include <contrecoup/gas/scene/gas_scene.h>
#include <contrecoup/gas/scene/scene_bursts.h>

#include "../../set_entries.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;

namespace
{
/// Entries of a charge of 1 kg at @p center and of the tables for it.
std::vector<std::string> charge_at(const std::string &center)
{
  return {"Material/Equation of state=jwl in air",
          "Material/Explosive=tnt",
          "Charges/Charge 1/Mass=1",
          "Charges/Charge 1/Center=" + center,
          "Reference/Kind=kingery bulmash",
          "Reference/Kingery Bulmash/Center=" + center};
}

/// Half of a box, y > 0, on rigid ground, with the given entries.
struct HalfBox
{
  explicit HalfBox(const std::vector<std::string> &lines,
                   const std::vector<std::string> &more = {})
  {
    TimeParameters::declare_parameters(prm);
    GasScene<3>::declare_parameters(prm);
    std::vector<std::string> all = {"Domain/Dimension=3",
                                    "Domain/Lower corner=-2, 0, 0",
                                    "Domain/Upper corner=2, 2, 2",
                                    "Domain/Coarse leaves=2, 1, 1",
                                    "Boundaries/y low=symmetry",
                                    "Boundaries/y high=open",
                                    "Boundaries/z low=wall"};
    all.insert(all.end(), lines.begin(), lines.end());
    all.insert(all.end(), more.begin(), more.end());
    set_entries(prm, all);
    scene.parse_parameters(prm);
    remarks = remarks_on_bursts(prm, scene.material, scene.coarse_mesh);
  }

  dealii::ParameterHandler prm;
  GasScene<3> scene;
  std::vector<std::string> remarks;
};
} // namespace

TEST(SceneBursts, ComparesOneChargeOnAPlaneOfSymmetry)
{
  const HalfBox box(charge_at("0, 0, 1"));
  EXPECT_TRUE(box.remarks.empty());
  EXPECT_TRUE(box.scene.reference.has_arrivals());
}

TEST(SceneBursts, WarnsOfAMirroredCharge)
{
  const HalfBox box(charge_at("0, 0.5, 1"));
  ASSERT_EQ(box.remarks.size(), 2U);
  EXPECT_NE(box.remarks[0].find("Charges/Charge 1 is 0.5 m away from the plane "
                                "of symmetry y = 0 m: its mirror image is "
                                "computed as well, 2 charges of 2 kg in all"),
            std::string::npos)
    << box.remarks[0];
  EXPECT_FALSE(box.scene.reference.has_arrivals());
}

// A charge next to a wall is alone: the wave that returns is its reflection.
TEST(SceneBursts, TakesAWallForAWall)
{
  const HalfBox box(charge_at("0, 0.5, 1"), {"Boundaries/y low=wall"});
  EXPECT_TRUE(box.remarks.empty());
  EXPECT_TRUE(box.scene.reference.has_arrivals());
}

TEST(SceneBursts, ComparesNothingWithTheTablesOfOneOfTwoCharges)
{
  const HalfBox box(
    charge_at("0, 0, 1"),
    {"Charges/Charge 2/Mass=0.5", "Charges/Charge 2/Center=1, 0, 1"});
  ASSERT_EQ(box.remarks.size(), 1U);
  EXPECT_NE(box.remarks[0].find("describes one charge, but there are 2"),
            std::string::npos)
    << box.remarks[0];
  EXPECT_FALSE(box.scene.reference.has_arrivals());
}

TEST(SceneBursts, WarnsOfAMirroredBall)
{
  const HalfBox box(
    {"Initial state/Kind=regions", "Initial state/Region a/Center=0, 1, 1"});
  ASSERT_EQ(box.remarks.size(), 1U);
  EXPECT_NE(box.remarks[0].find("Initial state/Region a is 1 m away"),
            std::string::npos)
    << box.remarks[0];
}

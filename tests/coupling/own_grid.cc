// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/coupling/scene/scene_layout.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>
#include <contrecoup/materials/explosives.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace contrecoup;
using namespace contrecoup::coupling;
using dealii::Point;

namespace
{
/// 2.268 kg of C-4 before a body, in coarse cells.
SceneParameters coarse_scene()
{
  SceneParameters scene;
  scene.accuracy = SceneParameters::accuracies.front();
  scene.element_size = scene.accuracy.element_size;
  scene.end_time = 0.1;
  scene.symmetry = "auto";
  scene.explosive = find_explosive("c-4");
  scene.mass = 2.268;
  scene.place = Point<3>(2.487, 0., 1.27);
  return scene;
}


RoundedBox upright_box()
{
  return {Point<3>(0., 0., 0.88), Point<3>(0.15, 0.25, 0.88), 0.05};
}


std::vector<Assignment> assignments(const std::vector<std::string> &lines)
{
  std::vector<Assignment> wrote;
  for (const std::string &line : lines)
    wrote.push_back(parse_override("Blast/" + line));
  return wrote;
}


OwnGrid grid_by(const std::vector<std::string> &lines)
{
  return OwnGrid::find(assignments(lines));
}
} // namespace


// Sides, leaves and cells that are told are those of the run.
TEST(OwnGrid, TakeTheDomainOfTheUser)
{
  SceneParameters scene = coarse_scene();
  const RoundedBox body = upright_box();
  const auto layout_of = [&](const std::vector<std::string> &lines) {
    return SceneLayout(scene, body, {}, grid_by(lines));
  };
  const SceneLayout usual = layout_of({});
  const SceneLayout corner = layout_of({"Domain/Lower corner=-4, -3, 0",
                                        "Domain/Upper corner=3, 0.64, 2.5",
                                        "Boundaries/y high=wall"});
  EXPECT_TRUE(usual.is_half);
  EXPECT_FALSE(corner.is_half);
  EXPECT_EQ(corner.lower, Point<3>(-4., -3., 0.));
  EXPECT_EQ(corner.upper, Point<3>(3., 0.64, 2.5));
  EXPECT_EQ(corner.n_leaves, (std::array<unsigned int, 3>{{11, 6, 4}}));
  EXPECT_DOUBLE_EQ(corner.leaf_edge, 7. / 11.);
  EXPECT_DOUBLE_EQ(corner.cell_size(),
                   7. / 11. / 4. / std::pow(2., corner.levels));

  // One corner alone leaves the other to the scene.
  const SceneLayout low = layout_of({"Domain/Upper corner=3, 3, 2"});
  EXPECT_EQ(low.lower, usual.lower);
  EXPECT_TRUE(low.is_half);

  // Larger leaves are refined until the preset's cells are reached.
  const SceneLayout large = layout_of({"Domain/Coarse leaves=2, 2, 2"});
  EXPECT_GT(large.leaf_edge, 2. * SceneLayout::leaf);
  EXPECT_LE(large.cell_size(), 0.04);
  EXPECT_GT(large.cell_size(), 0.005);

  // The plane of symmetry and the ground are where they are.
  EXPECT_FALSE(layout_of({"Domain/Lower corner=-4, -3, 0"}).is_half);
  EXPECT_THROW(layout_of({"Domain/Lower corner=-4, 0, -1"}), InputError);
  EXPECT_THROW(layout_of({"Domain/Upper corner=1e5, 1e5, 1e5"}), InputError);
  EXPECT_NO_THROW(
    layout_of({"Domain/Lower corner=-4, 0, -1", "Boundaries/z low=open"}));
  scene.symmetry = "y";
  EXPECT_THROW(layout_of({"Domain/Lower corner=-4, -3, 0"}), InputError);
  EXPECT_THROW(layout_of({"Boundaries/y low=wall"}), InputError);
  EXPECT_THROW(layout_of({"Boundaries/y high=wall"}), InputError);
}


// A scene without symmetry along y is not mirrored.
TEST(OwnGrid, MirrorNoSideOfTheUser)
{
  SceneParameters scene = coarse_scene();
  const RoundedBox body = upright_box();
  const auto is_half = [&](const std::vector<std::string> &lines) {
    return SceneLayout(scene, body, {}, grid_by(lines)).is_half;
  };
  EXPECT_TRUE(is_half({"Boundaries/x high=wall", "Boundaries/y high=open"}));
  EXPECT_FALSE(is_half({"Boundaries/y high=wall"}));
  EXPECT_FALSE(is_half({"Boundaries/y low=wall"}));
  EXPECT_FALSE(is_half({"Boundaries/y low=open"}));
  EXPECT_FALSE(is_half({"Boundaries/y low=wall", "Boundaries/y high=wall"}));
  EXPECT_TRUE(is_half({"Boundaries/y low=symmetry", "Boundaries/y high=wall"}));
  scene.symmetry = "y";
  EXPECT_TRUE(is_half({"Boundaries/y low=symmetry", "Boundaries/y high=wall"}));
  for (const char *side : {"y low=wall", "y low=open", "y high=wall"})
    EXPECT_THROW(is_half({std::string("Boundaries/") + side}), InputError)
      << side;
}


// It is on the other side of the body, nearer, or nowhere, where a side is
// near.
TEST(OwnGrid, KeepTheProbeWithinTheDomain)
{
  SceneParameters scene = coarse_scene();
  const RoundedBox body = upright_box();
  const auto probe = [&](const std::string &low, const std::string &high) {
    return SceneLayout(scene,
                       body,
                       {},
                       grid_by({"Domain/Lower corner=-4, " + low + ", 0",
                                "Domain/Upper corner=4, " + high + ", 4"}))
      .probe;
  };
  ASSERT_TRUE(probe("-3", "3"));
  EXPECT_NEAR((*probe("-3", "3"))[1], 0.6, 1e-12);
  ASSERT_TRUE(probe("-3", "0.5"));
  EXPECT_NEAR((*probe("-3", "0.5"))[1], -0.6, 1e-12);
  ASSERT_TRUE(probe("-0.5", "0.65"));
  EXPECT_NEAR((*probe("-0.5", "0.65"))[1], 0.45, 1e-12);
  EXPECT_FALSE(probe("-0.5", "0.5"));
  // Neither on a wall that the wave meets first.
  scene.place = Point<3>(0.1, 2.2, 1.27);
  const OwnGrid near = grid_by({"Domain/Upper corner=4, 4, 2"});
  ASSERT_TRUE(SceneLayout(scene, body, {}, near).probe);
  const double x = (*SceneLayout(scene, body, {}, near).probe)[0];
  EXPECT_LT(x, -0.2);
  for (const double gap : {0.1, 0.2})
    EXPECT_EQ(SceneLayout(scene,
                          body,
                          {},
                          grid_by({"Domain/Lower corner=" +
                                     std::to_string(x - gap) + ", -3, 0",
                                   "Domain/Upper corner=4, 4, 2"}))
                .probe.has_value(),
              gap > 0.15);
}


// A body is as thick, and its elements as small, however it is turned.
TEST(OwnGrid, TakeTheSidesOfTheBodyBeforeItIsTurned)
{
  SceneParameters scene = coarse_scene();
  scene.cell_size = 0.04;
  double depth = 0.;
  for (const char *rotation : {"0, 0, 0", "0, 0, -45", "0, 45, 0"})
  {
    dealii::ParameterHandler prm;
    BodyDescription::declare_parameters(prm);
    apply_assignments({parse_override("Kind=phantom"),
                       parse_override("Origin=bottom"),
                       parse_override(std::string("Rotation=") + rotation)},
                      prm);
    BodyDescription description;
    description.parse_parameters(prm);
    const SceneLayout layout(
      scene, *description.create()->surface(), description.unturned_box());
    if (depth == 0.)
      depth = layout.shortest_side();
    EXPECT_GT(depth, 0.3);
    EXPECT_LT(depth, 0.34); // of the voxels: 0.33
    EXPECT_EQ(layout.shortest_side(), depth) << rotation;
    EXPECT_EQ(layout.cells_across(), layout.shortest_side() / 0.04);
    EXPECT_NEAR(layout.unturned.side_length(2), 1.756, 0.005);
  }
}

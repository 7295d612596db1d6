// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/reflecting_plane.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace contrecoup;
using namespace contrecoup::coupling;
using dealii::Point;

namespace
{
SceneParameters open_scene(const std::string &explosive,
                           const double mass,
                           const Point<3> &charge,
                           const double end_time)
{
  SceneParameters scene;
  scene.accuracy = SceneParameters::accuracies[0];
  scene.explosive = find_explosive(explosive);
  scene.mass = mass;
  scene.place = charge;
  scene.end_time = end_time;
  scene.symmetry = "none";
  return scene;
}


SceneLayout open_layout(const SceneParameters &scene, const OwnGrid &own = {})
{
  return {scene,
          RoundedBox(Point<3>(0., 0., 0.88), Point<3>(0.15, 0.25, 0.88), 0.05),
          {},
          own};
}
} // namespace


// In a run with these sides, 3.84 m aside, the wave came 1.2 ms before that in
// free air and with twice its impulse. The tables have 36.7 ms on the direct
// way and 39.5 ms on that from the image, as the ground's reflection makes one
// wave with the front; the point source is 3 % later, and without the ground
// 11 %.
TEST(ReflectingPlane, KnowsOpenSidesThatTheFrontRunsAlong)
{
  const SceneParameters scene =
    open_scene("anfo", 50., {20.15, 0., 0.3}, 0.058);
  OwnGrid own;
  own.lower = Point<3>(-3.2, -3.84, 0.);
  own.upper = Point<3>(24.32, 3.84, 5.12);
  const SceneLayout near = open_layout(scene, own), chosen = open_layout(scene);
  EXPECT_EQ(grazed_sides(scene, near, {}),
            (std::vector<std::string>{"y low", "y high", "z high"}));
  EXPECT_TRUE(grazed_sides(scene, chosen, {}).empty());
  const double time = open_reflection_at_body(scene, near, {});
  EXPECT_NEAR(time, 0.0395, 0.0005);
  EXPECT_GT(open_reflection_at_body(scene, chosen, {}), scene.end_time);
  std::vector<ChosenSide> walls;
  for (const auto &[name, d] : {std::pair{"x low", 0U},
                                {"x high", 0U},
                                {"y low", 1U},
                                {"y high", 1U},
                                {"z high", 2U}})
    walls.push_back({name, "wall", d, name[2] == 'h'});
  EXPECT_EQ(open_reflection_at_body(scene, near, walls),
            std::numeric_limits<double>::infinity());
}


// One of the points makes the domain hold the plane, which is beyond that for
// body and charge.
TEST(ReflectingPlane, IsFarFromAllGaugesInADomainOfTheScene)
{
  SceneParameters scene = open_scene("c-4", 1.5, {4.09, 0., 0.08}, 0.0095);
  const GaugeRaster plane{{-1.5, 0., 1.2}, {3.5, 3., 1.2}};
  for (const Point<3> &place :
       {Point<3>(0.1, 2., 1.2), Point<3>(2., 1.5, 1.2), Point<3>(-1., 1., 1.2)})
    scene.gauges.push_back({place, place});
  scene.gauges.push_back(plane);
  const SceneLayout layout = open_layout(scene);
  ASSERT_LE(layout.lower[0], plane.begin[0]);
  for (const ReflectingPlane &side : open_planes(layout, {}))
  {
    const Point<3> image = side.image(layout.charge);
    EXPECT_GE(image.distance(plane.nearest(image)), layout.front_distance)
      << side.name;
  }
}

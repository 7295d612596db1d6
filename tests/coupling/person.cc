// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/coupling/scene/person.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>

#include "../set_entries.h"
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

using namespace contrecoup;
using namespace contrecoup::coupling;
using dealii::Point;
using dealii::Tensor;

namespace
{
using Lines = std::vector<std::string>;

/// A box as tall as a man, centred on the z axis, with landmarks that face +y.
/// @param ahead how far the ears are before the middle of the trunk [m]
/// @param thigh where the left one is, above a shin at (0.1, 0, 0.4)
ShapeBody box_with_landmarks(const double ahead = 0.,
                             const Point<3> &thigh = Point<3>(0.1, 0., 0.8))
{
  const auto surface = std::make_shared<RoundedBox>(
    Point<3>(0., 0., 0.9), Point<3>(0.25, 0.15, 0.9), 0.05);
  ShapeBody body(surface, {{{"all", Tissue::soft_tissue}, surface}});
  body.set_landmarks({{"chest", {0.01, 0.15, 1.3}},
                      {"back", {0., -0.15, 1.25}},
                      {"left ear", {-0.08, ahead, 1.65}},
                      {"right ear", {0.08, ahead, 1.65}},
                      {"left shin", {0.1, 0., 0.4}},
                      {"left thigh", thigh}});
  return body;
}


/// @param turns whether the body is turned by the entries too
Person person_by(const Lines &lines,
                 const Point<3> &charge = Point<3>(3., 0., 1.),
                 const bool turns = false)
{
  dealii::ParameterHandler prm;
  BodyDescription::declare_parameters(prm);
  set_entries(prm, lines);
  const Placement placement(
    1., turns ? Placement::read_rotation(prm) : Tensor<1, 3>(), {});
  return {prm, *box_with_landmarks().placed(placement), 58., charge};
}
} // namespace


TEST(Person, IsNamedByTheSideThatFacesTheCharge)
{
  for (const auto &[rotation, side, posture] :
       std::vector<std::tuple<std::string, std::string, std::string>>{
         {"0, 0, 0", "front", "standing"},
         {"0, 0, 40", "front", "standing"},
         {"0, 0, 90", "right side", "standing"},
         {"0, 0, 180", "back", "standing"},
         {"0, 0, -90", "left side", "standing"},
         {"0, 90, 0", "head", "lying"},
         {"0, -90, 0", "feet", "lying"},
         {"180, 0, 0", "front", "upside down"},
         {"0, 45, 0", "front", "inclined"}})
  {
    const Person person = person_by({"Rotation=" + rotation});
    EXPECT_EQ(person.side_to_charge(), side) << rotation;
    EXPECT_EQ(person.posture(), posture) << rotation;
  }
}


TEST(Person, HasTheAzimuthOfTheChargeFromTheFrontToTheLeft)
{
  const Person turned = person_by({"Rotation=0, 0, -30"});
  EXPECT_NEAR(turned.charge_azimuth(), 30., 1e-6);
  // From the middle of the body, 0.9 m above the ground.
  for (const double height : {0.05, 0.9, 1.4, 3.8})
    EXPECT_NEAR(person_by({}, Point<3>(2., 0., height)).charge_elevation(),
                std::atan2(height - 0.9, 2.) * 180. / dealii::numbers::PI,
                1e-6)
      << height;
}


// A charge level with face, breast or shins is neither above nor below.
TEST(Person, HasTheChargeBesideAnyHeightOfTheBody)
{
  const auto side = [](const Point<3> &charge) {
    return person_by({}, charge).side_to_charge();
  };
  for (const double height : {0.2, 1.2, 1.7})
  {
    EXPECT_EQ(side({0.4, 0., height}), "front") << height;
    EXPECT_EQ(side({0., 0.4, height}), "left side") << height;
  }
  EXPECT_EQ(side({0.1, 0., 2.2}), "head");
  EXPECT_EQ(side({0.1, 0., -0.3}), "feet");
}


// Whoever lies along the way to the charge has no angle to it.
TEST(Person, SaysWhereTheChargeIs)
{
  for (const auto &[rotation, words] : std::map<std::string, std::string>{
         {"0, 0, 0", "straight ahead of the person"},
         {"0, 0, -30", "30 degrees to the left of where the person faces"},
         {"0, 0, 180", "straight behind the person"},
         {"0, 0, -179.8", "straight behind the person"},
         {"0, 90, 0", "beyond the person's head"},
         {"0, -90, 0", "beyond the person's feet"}})
    EXPECT_EQ(person_by({"Rotation=" + rotation}).charge_in_words(), words);
  for (const auto &[rotation, side] : std::map<std::string, std::string>{
         {"0, 90, 0", "back"}, {"0, -90, 0", "front"}})
    EXPECT_EQ(
      person_by({"Rotation=" + rotation}, {0., 0., 5.}).charge_in_words(),
      "straight before the person's " + side);
  EXPECT_EQ(person_by({"Kind=shape"}).charge_in_words(), "");
  EXPECT_EQ(
    person_by({"Kind=image", "Rotation=0, 0, -30"}).charge_in_words(),
    "30 degrees to the left of where the person faces (the front of the image, "
    "+y of its header)");
}


TEST(Person, IsDescribedByStatureAndMass)
{
  EXPECT_EQ(
    person_by({"Phantom/Stature=1.62", "Phantom/Mass=58"}).description(),
    "a standing person of 1.62 m and 58 kg");
  EXPECT_EQ(person_by({"Phantom/Stature=1.6", "Scale=0.5"}).length(), 0.8);
  EXPECT_EQ(person_by({"Kind=shape"}).description(),
            "a shape of 58 kg, 1.8 m high");
  EXPECT_FALSE(person_by({"Kind=shape"}).axes());
  EXPECT_TRUE(std::isnan(person_by({"Kind=shape"}).charge_azimuth()));
  EXPECT_EQ(person_by({"Kind=shape"}).side_to_charge(), "");
}


// However the body is turned.
TEST(Person, OfImagesAndSurfacesIsAsLongAsTheBody)
{
  for (const std::string kind : {"image", "surface"})
    for (const std::string rotation :
         {"0, 0, 0", "0, 30, 0", "90, 0, 25", "20, -45, 10"})
      EXPECT_NEAR(person_by({"Kind=" + kind, "Rotation=" + rotation},
                            Point<3>(3., 0., 1.),
                            true)
                    .length(),
                  1.8,
                  1e-12)
        << kind << " " << rotation;
}


// A head that is held forward by 12 degrees tilts nobody; who sits has a height
// instead of a stature, however the trunk leans.
TEST(Person, OfASurfaceIsAsHighAsTheSurface)
{
  dealii::ParameterHandler prm;
  BodyDescription::declare_parameters(prm);
  prm.set("Kind", "surface");
  const Point<3> charge(3., 0., 1.), forward(0.1, 0.5, 0.5);
  const Person stands(prm, box_with_landmarks(0.08), 58., charge);
  EXPECT_EQ(stands.description(), "a standing person of 1.8 m and 58 kg");
  EXPECT_NEAR(stands.axes()->up[2], 1., 1e-12);
  const Person sits(prm, box_with_landmarks(0.08, forward), 58., charge);
  EXPECT_EQ(sits.description(), "a seated person of 58 kg, 1.8 m high");
  const Person leans(prm, box_with_landmarks(0.3, forward), 58., charge);
  EXPECT_EQ(leans.description(), "an inclined person of 58 kg, 1.8 m high");
  EXPECT_LT(leans.axes()->up[2], 0.9);
}


// Whatever the entries, a person in a file faces where its landmarks say.
TEST(Person, OfASurfaceFacesAsItsLandmarks)
{
  const Person person = person_by({"Kind=surface"});
  ASSERT_TRUE(person.axes());
  EXPECT_NEAR(person.axes()->forward[1], 1., 1e-12);
  EXPECT_NEAR(person.axes()->left[0], -1., 1e-12);
  EXPECT_NEAR(person.axes()->up[2], 1., 1e-12);
  EXPECT_EQ(person.side_to_charge(), "right side");
  EXPECT_NEAR(person.length(), 1.8, 1e-12);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/body/body_description.h>

#include "../set_entries.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using dealii::Point;

namespace
{
BodyDescription describe(const std::vector<std::string> &lines)
{
  return described<BodyDescription>(lines);
}

/// Cubes by part, and the grid they are in.
struct Filled
{
  LabelGrid grid;
  std::map<std::string, double> volume;
};

Filled fill(const Body &body, const double spacing)
{
  Filled filled;
  filled.grid = make_grid(body.surface()->bounding_box(), spacing);
  body.fill(filled.grid);
  for (const unsigned char label : filled.grid.labels)
    if (label != LabelGrid::outside)
      filled.volume[body.parts()[label].name] += filled.grid.volume();
  return filled;
}

/// Volume of the parts that a reference names.
double volume_of(const Filled &filled, const OrganReference &reference)
{
  double sum = 0.;
  for (const auto &[name, volume] : filled.volume)
    if (reference.parts.empty() ||
        std::count(reference.parts.begin(), reference.parts.end(), name) > 0)
      sum += volume;
  return sum;
}

std::string refusal(const std::vector<std::string> &lines)
{
  try
  {
    describe(lines);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}
} // namespace


TEST(Phantom, OrgansHaveTheirVolumes)
{
  const BodyDescription description = describe({"Kind=phantom"});
  const BodyPointer body = description.create();
  const Filled filled = fill(*body, 0.005);
  const auto references = description.references();
  ASSERT_EQ(references.size(), 6u);
  for (const OrganReference &reference : references)
    EXPECT_NEAR(
      volume_of(filled, reference) / reference.volume, 1., reference.tolerance)
      << reference.name;
  EXPECT_EQ(count_components(filled.grid)[LabelGrid::outside], 1u);
}


TEST(Phantom, FollowsStatureAndMass)
{
  for (const auto &[stature, mass] :
       {std::pair<std::string, std::string>{"1.6", "50"}, {"1.95", "120"}})
  {
    const BodyDescription description =
      describe({"Phantom/Stature=" + stature, "Phantom/Mass=" + mass});
    const Filled filled = fill(*description.create(), 0.008);
    const auto references = description.references();
    EXPECT_NEAR(volume_of(filled, references[0]),
                std::stod(mass) / 990.,
                5e-3 * std::stod(mass) / 990.);
    // Organs follow the stature; at this size of cubes within a tenth.
    const double growth = std::pow(std::stod(stature) / 1.756, 3);
    EXPECT_NEAR(filled.volume.at("liver") / (1.70e-3 * growth), 1., 0.1);
    EXPECT_NEAR(filled.volume.at("brain") / 1.40e-3, 1., 0.1);
    ASSERT_EQ(references[5].name, "skeleton");
    EXPECT_NEAR(volume_of(filled, references[5]) / references[5].volume,
                1.,
                references[5].tolerance);
  }
}


TEST(Phantom, StandsUprightOnTheGroundAndIsSymmetric)
{
  const BodyPointer body = describe({"Phantom/Stature=1.8"}).create();
  const auto surface = body->surface();
  EXPECT_GE(surface->bounding_box().lower_bound(2), 0.);
  EXPECT_LT(surface->value({0., 0., 1.799}), 0.);
  EXPECT_GT(surface->value({0., 0., 1.801}), 0.);
  // Soles touch the ground, and there is air between the legs.
  EXPECT_LT(surface->value({-0.049, 0.113, 0.002}), 0.);
  EXPECT_GT(surface->value({0., 0., 0.3}), 0.01);
  for (const Point<3> &point : {Point<3>(0.03, 0.1, 1.3),
                                Point<3>(0., 0.25, 1.),
                                Point<3>(0.05, 0.05, 1.7),
                                Point<3>(0.1, 0.12, 0.05)})
    EXPECT_NEAR(surface->value(point),
                surface->value({point[0], -point[1], point[2]}),
                1e-12);
}


TEST(Phantom, LandmarksAreOnTheSkinWhereTheirNamesSay)
{
  struct Case
  {
    std::vector<std::string> lines;
    unsigned int forward; ///< axis that the man faces
    double head;          ///< factor of his head
  };
  for (const Case &man :
       {Case{{}, 0, 1.},
        Case{{"Phantom/Mass=115"}, 0, 1.},
        Case{
          {"Phantom/Stature=1.6", "Phantom/Mass=50", "Phantom/Head scale=1.1"},
          0,
          1.1},
        Case{{"Scale=0.5", "Rotation=0, 0, 90", "Shift=1, 2, 3"}, 1, 0.5}})
  {
    const BodyPointer body = describe(man.lines).create();
    std::map<std::string, Point<3>> places;
    for (const Landmark &landmark : body->landmarks())
    {
      EXPECT_NEAR(body->surface()->value(landmark.place), 0., 1e-6)
        << landmark.name;
      places[landmark.name] = landmark.place;
    }
    ASSERT_EQ(places.size(), 21u);
    const auto box = body->surface()->bounding_box();
    const double height = box.side_length(2);
    EXPECT_NEAR(places.at("vertex")[2], box.upper_bound(2), 1e-6);
    const auto depth = [&](const std::string &front, const std::string &back) {
      return places.at(front)[man.forward] - places.at(back)[man.forward];
    };
    for (const std::string side : {"left ", "right "})
      EXPECT_GT(depth(side + "shin", side + "calf"), 0.04 * height);
    // The head is 197 mm long, and 135 mm wide 45 mm before its middle.
    EXPECT_NEAR(depth("forehead", "occiput") / man.head, 0.19, 0.01);
    EXPECT_GT(depth("chest", "back"), 0.1 * height);
    const auto across = places.at("left temple") - places.at("right temple");
    EXPECT_NEAR(across.norm() / man.head, 0.135, 0.003);
    EXPECT_GT(across[1 - man.forward] * (man.forward == 0 ? 1. : -1.), 0.);
    // The arms hang next to the trunk, as high as the chest.
    const auto wide =
      places.at("left upper arm") - places.at("right upper arm");
    EXPECT_GT(wide * across, 0.99 * wide.norm() * across.norm());
    EXPECT_GT(wide.norm(), 1.2 * depth("chest", "back"));
    EXPECT_NEAR(
      places.at("left upper arm")[2], places.at("chest")[2], 0.02 * height);
    EXPECT_NEAR(
      (places.at("left shin")[2] - box.lower_bound(2)) / height, 0.17, 0.01);
  }
}


// However the phantom is turned.
TEST(Phantom, StandsOnTheGroundWithItsBottom)
{
  for (const std::string rotation : {"0, 45, 0", "-90, 0, 0", "20, -130, 70"})
  {
    const auto surface =
      describe({"Origin=bottom", "Rotation=" + rotation}).create()->surface();
    const auto box = surface->bounding_box();
    EXPECT_NEAR(box.lower_bound(2), 0., 1e-12);
    EXPECT_NEAR(box.center()[0], 0., 1e-12);
    // The voxels of the body span its box to within one.
    constexpr double spacing = 0.005;
    LabelGrid grid = make_grid(box, spacing);
    ShapeBody(surface, {{{"", Tissue::none}, surface}}).fill(grid);
    dealii::BoundingBox<3> filled({box.center(), box.center()});
    for (unsigned int k = 0; k < grid.size[2]; ++k)
      for (unsigned int j = 0; j < grid.size[1]; ++j)
        for (unsigned int i = 0; i < grid.size[0]; ++i)
          if (grid.at(i, j, k) != LabelGrid::outside)
            filled.merge_with(dealii::BoundingBox<3>(
              {grid.center(i, j, k), grid.center(i, j, k)}));
    for (unsigned int d = 0; d < 3; ++d)
    {
      EXPECT_NEAR(filled.lower_bound(d), box.lower_bound(d), spacing)
        << rotation;
      EXPECT_NEAR(filled.upper_bound(d), box.upper_bound(d), spacing)
        << rotation;
    }
  }
}


TEST(Phantom, SkinIsALayer)
{
  const BodyPointer body = describe({"Phantom/Skin thickness=0.006"}).create();
  EXPECT_EQ(body->parts().back().tissue, Tissue::skin);
  const Filled filled = fill(*body, 0.005);
  // 6 mm below 1.84 m^2, and more where the surface is blended.
  EXPECT_GT(filled.volume.at("skin"), 0.0095);
  EXPECT_LT(filled.volume.at("skin"), 0.0135);
}


TEST(Phantom, ImpossibleMenAreRefused)
{
  const std::string message =
    refusal({"Phantom/Stature=1.9", "Phantom/Mass=50"});
  EXPECT_NE(message.find("13.9 kg/m^2"), std::string::npos) << message;
  EXPECT_NE(message.find("61.4 to 144 kg"), std::string::npos) << message;
}


// An ellipsoid with half axes of 84, 68 and 60 mm below 14 mm of layers.
TEST(SimpleBody, IsAsHighAsItIsTurned)
{
  const auto head = describe({"Kind=shape",
                              "Shape/Shape=layered head",
                              "Origin=bottom",
                              "Rotation=0, 20, 90"})
                      .create()
                      ->surface();
  const auto box = head->bounding_box();
  const double sine = std::sin(M_PI / 9.), cosine = std::cos(M_PI / 9.);
  EXPECT_NEAR(box.side_length(2),
              2. * (std::hypot(0.084 * sine, 0.060 * cosine) + 0.014),
              1e-12);
  EXPECT_NEAR(box.side_length(1),
              2. * (std::hypot(0.084 * cosine, 0.060 * sine) + 0.014),
              1e-12);
  EXPECT_NEAR(box.side_length(0), 0.164, 1e-12);
  EXPECT_NEAR(box.lower_bound(2), 0., 1e-12);
}


TEST(SimpleBody, LayersOfAHead)
{
  const BodyPointer head =
    describe({"Kind=shape", "Shape/Shape=layered head", "Shape/Size=0.07"})
      .create();
  ASSERT_EQ(head->parts().size(), 4u);
  EXPECT_EQ(head->parts()[0].tissue, Tissue::brain);
  EXPECT_EQ(head->part_at({0.069, 0., 0.}), 0);
  EXPECT_EQ(head->part_at({0.071, 0., 0.}), 1);
  EXPECT_EQ(head->part_at({0., 0.073, 0.}), 2);
  EXPECT_EQ(head->part_at({0., 0., 0.080}), 3);
  EXPECT_EQ(head->part_at({0., 0., 0.085}), LabelGrid::outside);
}


TEST(SimpleBody, VolumesOfTheShapes)
{
  const auto volume = [](const std::vector<std::string> &lines) {
    std::vector<std::string> all{"Kind=shape"};
    all.insert(all.end(), lines.begin(), lines.end());
    double sum = 0.;
    for (const auto &[name, part] : fill(*describe(all).create(), 0.005).volume)
      sum += part;
    return sum;
  };
  EXPECT_NEAR(
    volume({"Shape/Shape=box", "Shape/Size=0.1, 0.2, 0.3"}), 0.006, 1e-9);
  EXPECT_NEAR(volume({"Shape/Shape=cylinder", "Shape/Size=0.1, 0.2"}),
              M_PI * 0.002,
              6e-5);
  EXPECT_NEAR(volume({"Shape/Shape=ellipsoid", "Shape/Size=0.1, 0.2, 0.15"}),
              4. / 3. * M_PI * 0.003,
              5e-5);
  EXPECT_NEAR(volume({"Scale=2", "Shape/Shape=sphere", "Shape/Size=0.1"}),
              4. / 3. * M_PI * 0.008,
              1e-4);
}


TEST(SimpleBody, WhatDoesNotFitIsRefused)
{
  EXPECT_NE(refusal({"Kind=shape", "Shape/Size=1, 2"}).find("needs 1"),
            std::string::npos);
  EXPECT_NE(refusal({"Kind=shape", "Shape/Layers=0.1"}).find("has none"),
            std::string::npos);
  EXPECT_NE(
    refusal(
      {"Kind=shape", "Shape/Shape=surrogate head", "Shape/Layers=0.01, 0.02"})
      .find("2 tissue(s) for a core and 2 layer(s)"),
    std::string::npos);
  EXPECT_NE(refusal({"Kind=shape", "Shape/Tissues=bone marow"})
              .find("Body/Shape/Tissues"),
            std::string::npos);
  EXPECT_NE(refusal({"Kind=shape", "Shape/Tissues=livr"}).find("liver"),
            std::string::npos);
}

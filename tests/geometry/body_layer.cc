// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/geometry/body/body_layer.h>

#include <gtest/gtest.h>

using namespace contrecoup;

namespace
{
std::vector<BodyLayer> layers_of(const std::vector<std::string> &texts)
{
  ParameterHandler prm;
  {
    const Section section(prm, "Body");
    BodyDescription::declare_parameters(prm);
  }
  std::vector<Assignment> assignments;
  for (const std::string &text : texts)
    assignments.push_back(parse_override("Body/" + text));
  apply_assignments(assignments, prm);
  return read_layers(prm);
}

using Lines = std::vector<std::string>;
} // namespace

TEST(BodyLayer, WarnsOfAThicknessOfTheUser)
{
  const auto layers = layers_of({"Phantom/Skin thickness=0.004"});
  EXPECT_EQ(thin_layer_lines(layers, 0.01, 0.01, "Mesh/Element size"),
            (Lines{"WARNING: skin, 4 mm (Body/Phantom/Skin thickness) is "
                   "thinner than the elements of 10 mm, so that there are "
                   "holes; Mesh/Element size of at most 4 mm closes them",
                   "  cerebrospinal fluid, 2.5 mm (Body/Phantom) is thinner "
                   "than the elements of 10 mm, so that there are holes; "
                   "Mesh/Element size of at most 2.5 mm closes them"}));
  EXPECT_EQ(thin_layer_lines(layers, 0.0025, 0.01, "Mesh/Element size"),
            Lines{});
}

TEST(BodyLayer, OfASurfaceIsTheFluidOfItsOrgans)
{
  EXPECT_TRUE(layers_of({"Kind=surface"}).empty());
  const auto layers = layers_of({"Kind=surface", "Surface/Organs=phantom"});
  ASSERT_EQ(layers.size(), 1U);
  EXPECT_EQ(layers[0].part, "cerebrospinal fluid");
}

TEST(BodyLayer, WarnsOfElementsThatTheUserMakesLarge)
{
  const auto layers = layers_of({"Kind=shape", "Shape/Shape=layered head"});
  ASSERT_EQ(layers.size(), 3U);
  const auto usual = thin_layer_lines(layers, 0.0032, 0.0032, "Element size");
  ASSERT_EQ(usual.size(), 1U);
  EXPECT_EQ(usual[0].find("  layer 1, 2.5 mm (Body/Shape/Layers) is"), 0U)
    << usual[0];
  const auto large = thin_layer_lines(layers, 0.02, 0.0032, "Element size");
  ASSERT_EQ(large.size(), 1U);
  EXPECT_EQ(large[0].find("WARNING: layer 1, 2.5 mm (Body/Shape/Layers), layer "
                          "2, 6.5 mm (Body/Shape/Layers), layer 3, 5 mm "
                          "(Body/Shape/Layers) are thinner"),
            0U)
    << large[0];
}

TEST(BodyLayer, KnowsLayersOfEachKindOfBody)
{
  const std::vector<std::string> head{"Kind=image",
                                      "Image/Kind=t1 and brain mask",
                                      "Image/Head/Skull thickness=0.008",
                                      "Scale=2"};
  const auto layers = layers_of(head);
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[1].entry, "Body/Image/Head/Skull thickness");
  EXPECT_DOUBLE_EQ(layers[1].thickness, 0.016);
  EXPECT_FALSE(layers[1].is_usual);
  EXPECT_TRUE(layers[2].is_usual);
  EXPECT_TRUE(layers_of({"Kind=surface"}).empty());
  EXPECT_TRUE(layers_of({"Kind=shape", "Shape/Shape=box"}).empty());
}

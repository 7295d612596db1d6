// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/geometry/body/body_layer.h>
#include <contrecoup/geometry/image/part_thickness.h>

#include "../set_entries.h"
#include "nifti_content.h"
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

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
  set_entries(prm, texts, "Body/");
  return read_layers(prm);
}

using Lines = std::vector<std::string>;
} // namespace

TEST(BodyLayer, WarnsOfAThicknessOfTheUser)
{
  const auto layers = layers_of({"Phantom/Skin thickness=0.004"});
  EXPECT_EQ(
    thin_layer_lines(layers, 0.01, 0.01, "Mesh/Element size"),
    (Lines{"WARNING: skin, 4 mm (Body/Phantom/Skin thickness) is "
           "thinner than the elements of 10 mm, so that it has holes or "
           "no element; Mesh/Element size of at most 2.3 mm closes "
           "the holes",
           "cerebrospinal fluid, 2.5 mm (Body/Phantom), skull, 6.5 mm "
           "(Body/Phantom) are thinner than the elements of 10 mm, so "
           "that they have holes or no element; spinal cord, 11 mm "
           "(Body/Phantom) is thinner than the diagonal of these and "
           "may be in pieces; Mesh/Element size of at most 1.4 mm "
           "closes the holes"}));
  EXPECT_EQ(thin_layer_lines(layers, 0.0024, 0.01, "Mesh/Element size"),
            (Lines{"cerebrospinal fluid, 2.5 mm (Body/Phantom) is thinner than "
                   "the diagonal of elements of 2.4 mm and may be in pieces; "
                   "Mesh/Element size of at most 1.4 mm closes the holes"}));
  EXPECT_EQ(thin_layer_lines(layers, 0.0014, 0.01, "Mesh/Element size"),
            Lines{});
}

TEST(BodyLayer, NamesTheSpinalCordOfASmallPerson)
{
  const auto lines = [](const std::string &stature) {
    return thin_layer_lines(layers_of({"Phantom/Stature=" + stature}),
                            0.01,
                            0.01,
                            "Mesh/Element size");
  };
  ASSERT_EQ(lines("1.58").size(), 1U);
  EXPECT_NE(lines("1.58")[0].find("spinal cord, 9.9 mm (Body/Phantom) are "),
            std::string::npos);
  EXPECT_NE(lines("1.756")[0].find("spinal cord, 11 mm (Body/Phantom) is "),
            std::string::npos);
}

TEST(BodyLayer, OfASurfaceAreThoseOfItsOrgans)
{
  EXPECT_TRUE(layers_of({"Kind=surface"}).empty());
  const auto layers = layers_of({"Kind=surface", "Surface/Organs=phantom"});
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[0].part, "cerebrospinal fluid");
  EXPECT_EQ(layers[1].part, "skull");
  EXPECT_EQ(layers[2].part, "spinal cord");
}

TEST(BodyLayer, HasHolesWhereElementsAreTooLarge)
{
  const BodyLayer cord = layers_of({})[2];
  for (const auto &[size, n_pieces, has] : {std::tuple{0.012, 1U, true},
                                            std::tuple{0.01, 1U, false},
                                            std::tuple{0.01, 2U, true},
                                            std::tuple{0.006, 2U, false}})
    EXPECT_EQ(has_holes(cord, n_pieces, size), has) << size << " " << n_pieces;
  EXPECT_EQ(layer_pieces_line(cord, 2, 0.01, "Mesh/Element size"),
            "spinal cord of 11 mm (Body/Phantom) is in 2 pieces of elements; "
            "Mesh/Element size of at most 6.3 mm closes it");
  EXPECT_EQ(layer_pieces_line(cord, 0, 0.016, "Mesh/Element size"),
            "WARNING: spinal cord of 11 mm (Body/Phantom) has no element; "
            "Mesh/Element size of at most 6.3 mm closes it");
  EXPECT_EQ(layer_pieces_line(cord, 1, 0.01, "Mesh/Element size"), "");
  EXPECT_EQ(layer_pieces_line(cord, 2, 0.006, "Mesh/Element size"), "");
  EXPECT_EQ(layer_pieces_line(cord, 2, 0.012, "Mesh/Element size"), "");
  const BodyLayer layer = layers_of({"Kind=shape",
                                     "Shape/Shape=layered head",
                                     "Shape/Layers=0.003, 0.0065, 0.005"})
                            .front();
  EXPECT_EQ(layer_pieces_line(layer, 2, 0.003, "Element size"),
            "WARNING: layer 1: cerebrospinal fluid of 3 mm "
            "(Body/Shape/Layers) is in 2 pieces of elements; Element size of "
            "at most 1.7 mm closes it");
}

TEST(BodyLayer, WarnsOfElementsThatTheUserMakesLarge)
{
  const auto layers = layers_of({"Kind=shape", "Shape/Shape=layered head"});
  ASSERT_EQ(layers.size(), 3U);
  const auto usual = thin_layer_lines(layers, 0.0032, 0.0032, "Element size");
  ASSERT_EQ(usual.size(), 1U);
  EXPECT_EQ(usual[0].find(
              "layer 1: cerebrospinal fluid, 2.5 mm (Body/Shape/Layers) is"),
            0U)
    << usual[0];
  const auto large = thin_layer_lines(layers, 0.02, 0.0032, "Element size");
  ASSERT_EQ(large.size(), 1U);
  EXPECT_EQ(
    large[0].find(
      "WARNING: layer 1: cerebrospinal fluid, 2.5 mm (Body/Shape/Layers), layer "
      "2: skeleton, 6.5 mm (Body/Shape/Layers), layer 3: soft tissue, 5 mm "
      "(Body/Shape/Layers) are thinner"),
    0U)
    << large[0];
}

// Thicker than the usual one in the same elements is no reason to warn.
TEST(BodyLayer, WarnsOfFewerElementsAcrossThanUsual)
{
  for (const auto &[layers, is_warned] :
       {std::pair{"0.003,0.0065,0.005", false},
        std::pair{"0.0025,0.0065,0.005", false},
        std::pair{"0.0024,0.0065,0.005", true},
        std::pair{"0.05,0.05,0.003", true}})
  {
    const auto found =
      thin_layer_lines(layers_of({"Kind=shape",
                                  "Shape/Shape=layered head",
                                  std::string("Shape/Layers=") + layers}),
                       0.0032,
                       0.0032,
                       "Element size");
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].find("WARNING: ") == 0, is_warned) << found[0];
  }
}

// Elements of a layer have no holes where their diagonal is its thickness.
TEST(BodyLayer, WarnsOfALayerThatMayBeInPieces)
{
  const auto layers = layers_of({"Kind=shape",
                                 "Shape/Shape=layered head",
                                 "Shape/Layers=0.003, 0.0065, 0.005"});
  const std::string
    layer =
      "WARNING: layer 1: cerebrospinal fluid, 3 mm (Body/Shape/Layers) is "
      "thinner than the diagonal of elements of ",
    advice = " and may be in pieces; Element size of at most "
             "1.7 mm closes it";
  // The others are thicker, or as thick as usual.
  for (const auto &[size, words] :
       {std::pair{0.003, "3 mm"}, std::pair{0.0018, "1.8 mm"}})
    EXPECT_EQ(uncertain_layer_lines(layers, size, "Element size"),
              Lines{layer + words + advice});
  for (const double size : {0.0017, 0.0031})
    EXPECT_EQ(uncertain_layer_lines(layers, size, "Element size"), Lines{});
  EXPECT_EQ(uncertain_layer_lines(layers, 0.0029, "Element size").size(), 1U);
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
  EXPECT_NE(layers[1].thickness, layers[1].usual);
  EXPECT_EQ(layers[2].thickness, layers[2].usual);
  EXPECT_TRUE(layers_of({"Kind=surface"}).empty());
  EXPECT_TRUE(layers_of({"Kind=shape", "Shape/Shape=box"}).empty());
}


// In the first part nine voxels have rows of 2 mm, two of 4 mm; the third has
// no voxel.
TEST(PartThickness, IsThatOfMostVoxels)
{
  const std::vector<unsigned char> parts{
    0, 0, 1, 255, 0, 0, 0, 0, 0, 0, 0, 1, 255, 0, 0, 255, 255, 255};
  const auto found =
    part_thicknesses({{9, 2, 1}}, {{1e-3, 2e-3, 9e-3}}, parts, 3);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_NEAR(found[0], 2e-3, 1e-9);
  EXPECT_NEAR(found[1], 1e-3, 1e-9);
  EXPECT_EQ(found[2], 0.);
}


TEST(BodyLayer, OfLabelsAreAsThickAsTheirVoxels)
{
  // A shell of 3 mm around a core of 6 x 6 x 6 voxels of 1.5 mm.
  Header header{{{10, 10, 10}}, {{1.5F, 1.5F, 1.5F}}};
  std::vector<short> labels;
  for (int i = 0; i < 1000; ++i)
  {
    const auto is_core = [](const int x) { return x > 1 && x < 8; };
    labels.push_back(
      is_core(i % 10) && is_core(i / 10 % 10) && is_core(i / 100) ? 7 : 2);
  }
  const std::filesystem::path file =
    std::filesystem::temp_directory_path() /
    ("contrecoup_shell_" + std::to_string(getpid()) + ".nii");
  std::ofstream(file, std::ios::binary) << make_nifti(header, labels);
  const auto layers = layers_of(
    {"Kind=image",
     "Scale=2",
     "Image/File=" + file.string(),
     "Image/Labels=1-3: fluid = cerebrospinal fluid; 7: brain; 8: none"});
  std::filesystem::remove(file);
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].part, "fluid");
  EXPECT_NEAR(layers[0].thickness, 6e-3, 1e-8);
  EXPECT_NEAR(layers[1].thickness, 18e-3, 1e-8);
  EXPECT_EQ(
    thin_layer_lines(layers, 0.01, 0.01, "Mesh/Element size"),
    Lines{"fluid, 6 mm (Body/Image/File) is thinner than the elements of "
          "10 mm, so that it has holes or no element; Mesh/Element size of at "
          "most 3.4 mm closes the holes"});
}

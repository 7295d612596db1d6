// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/body/body_description.h>

#include "nifti_content.h"
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

using namespace contrecoup;
using dealii::Point;
using dealii::Tensor;

namespace
{
/// Voxel axis of each direction right, forward, up, and its sign.
struct StorageOrder
{
  std::array<unsigned int, 3> axis;
  std::array<int, 3> sign;
};

/// A box of 6 x 4 x 2 voxels of 1 mm around one of 2 x 2 x 2, from the origin
/// to the right, forward and up.
std::string make_box(const StorageOrder &order)
{
  const auto is_between = [](const int x, const int first, const int last) {
    return x >= first && x <= last;
  };
  const std::array<int, 3> first{{-2, -3, -1}}, size{{10, 9, 5}};
  Header header{{{0, 0, 0}}};
  std::array<std::array<float, 4>, 3> rows{};
  for (unsigned int d = 0; d < 3; ++d)
  {
    header.size[order.axis[d]] = static_cast<short>(size[d]);
    rows[d][order.axis[d]] = static_cast<float>(order.sign[d]);
    rows[d][3] =
      static_cast<float>(order.sign[d] > 0 ? first[d] : first[d] + size[d] - 1);
  }
  std::vector<short> values;
  std::array<int, 3> voxel, x;
  for (voxel[2] = 0; voxel[2] < header.size[2]; ++voxel[2])
    for (voxel[1] = 0; voxel[1] < header.size[1]; ++voxel[1])
      for (voxel[0] = 0; voxel[0] < header.size[0]; ++voxel[0])
      {
        for (unsigned int d = 0; d < 3; ++d)
          x[d] =
            static_cast<int>(rows[d][3]) + order.sign[d] * voxel[order.axis[d]];
        const bool is_inside = is_between(x[0], 0, 5) &&
                               is_between(x[1], 0, 3) && is_between(x[2], 0, 1);
        const bool is_inner =
          is_inside && is_between(x[0], 1, 2) && is_between(x[1], 1, 2);
        values.push_back(is_inner ? 2 : (is_inside ? 1 : 0));
      }
  std::string bytes = make_nifti(header, values);
  std::memcpy(&bytes[280], rows.data(), sizeof(rows));
  return bytes;
}

class Images : public ::testing::Test
{
protected:
  Images()
    : folder_(std::filesystem::temp_directory_path() /
              ("contrecoup_images_" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(folder_);
  }

  ~Images() override
  {
    std::filesystem::remove_all(folder_);
  }

  std::string write(const std::string &name, const std::string &bytes) const
  {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  std::string write_compressed(const std::string &name,
                               const std::string &bytes) const
  {
    const std::string path = folder_ / name;
    gzFile file = gzopen(path.c_str(), "wb");
    gzwrite(file, bytes.data(), bytes.size());
    gzclose(file);
    return path;
  }

  static BodyDescription describe(const std::vector<std::string> &lines)
  {
    dealii::ParameterHandler prm;
    BodyDescription::declare_parameters(prm);
    std::vector<Assignment> assignments{parse_override("Kind=image")};
    for (const std::string &line : lines)
      assignments.push_back(parse_override(line));
    apply_assignments(assignments, prm);
    BodyDescription description;
    description.parse_parameters(prm);
    return description;
  }

  static BodyPointer create(const std::vector<std::string> &lines)
  {
    return describe(lines).create();
  }

  static std::string refusal(const std::vector<std::string> &lines)
  {
    try
    {
      create(lines);
    }
    catch (const InputError &error)
    {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_;
};

const Header small{{{3, 2, 2}}, {{2.F, 3.F, 4.F}}};
const std::vector<short> small_labels{1, 0, 2, 1, 1, 2, 1, 0, 2, 1, 3, 3};
const std::string table = "Image/Labels=1: brain; 2-3: skeleton";
} // namespace


TEST_F(Images, VoxelsAreWhereTheHeaderSays)
{
  const std::vector<std::string> files{
    write("a.nii", make_nifti(small, small_labels)),
    write_compressed("b.nii.gz", make_nifti(small, small_labels)),
    write("c.hdr", make_nifti(small, small_labels, true))};
  write("c.img",
        std::string(reinterpret_cast<const char *>(small_labels.data()), 24));
  for (const std::string &file : files)
  {
    const BodyPointer body = create(
      {"Image/File=" + file, "Image/Labels=1: brain; 2-3: hard = skeleton"});
    ASSERT_EQ(body->parts().size(), 2u);
    EXPECT_EQ(body->parts()[1].name, "hard");
    EXPECT_EQ(body->parts()[1].tissue, Tissue::skeleton);
    // Ours: x forward is NIfTI's second axis here, y left the first.
    EXPECT_EQ(body->part_at({0., 0., 0.}), 0);
    EXPECT_EQ(body->part_at({0., 0.002, 0.}), LabelGrid::outside);
    EXPECT_EQ(body->part_at({0., 0.004, 0.}), 1);
    EXPECT_EQ(body->part_at({0.003, 0.002, 0.}), 0);
    EXPECT_EQ(body->part_at({0., 0.002, 0.004}), LabelGrid::outside);
    EXPECT_EQ(body->part_at({0.003, 0.0029, 0.0055}), 1);
    EXPECT_EQ(body->part_at({0.003, 0.0029, 0.0061}), LabelGrid::outside);
    EXPECT_EQ(body->part_at({-0.002, 0., 0.}), LabelGrid::outside);
  }
}

// 10 mm to the right, 20 to the front and 30 up, in each unit.
TEST_F(Images, PlaceAndUnitAreThoseOfTheHeader)
{
  for (const Form form : {Form::matrix, Form::quaternion})
    for (const auto &[unit, size] :
         {std::pair<char, float>{1, 1e-3F}, {2, 1.F}, {3, 1e3F}})
    {
      SCOPED_TRACE(int(unit));
      Header header = small;
      header.form = form;
      header.unit = unit;
      header.place = {{10.F * size, 20.F * size, 30.F * size}};
      for (float &spacing : header.spacing)
        spacing *= size;
      const BodyPointer body = create(
        {"Image/File=" + write("a.nii", make_nifti(header, small_labels)),
         "Image/Labels=1: brain; 2-3: skeleton"});
      const auto part_at = [&](const double x, const double y, const double z) {
        return body->part_at({0.02 + x, -0.01 + y, 0.03 + z});
      };
      EXPECT_EQ(part_at(0., 0., 0.), 0);
      EXPECT_EQ(part_at(0., 0.002, 0.), LabelGrid::outside);
      EXPECT_EQ(part_at(0., 0.004, 0.), 1);
      EXPECT_EQ(part_at(0.003, 0.0029, 0.0055), 1);
      EXPECT_EQ(part_at(0.003, 0.0029, 0.0061), LabelGrid::outside);
      EXPECT_EQ(part_at(-0.002, 0., 0.), LabelGrid::outside);
    }
}

TEST_F(Images, WithoutAFormTheFirstAxisIsToTheRight)
{
  Header header = small;
  header.form = Form::none;
  const BodyPointer body =
    create({"Image/File=" + write("a.nii", make_nifti(header, small_labels)),
            "Image/Labels=1: brain; 2-3: skeleton"});
  EXPECT_EQ(body->part_at({0., 0., 0.}), 0);
  EXPECT_EQ(body->part_at({0., -0.004, 0.}), 1);
  EXPECT_EQ(body->part_at({0.003, -0.002, 0.}), 0);
  EXPECT_EQ(body->part_at({0., 0.004, 0.}), LabelGrid::outside);
}

// A stored 3 stands for 2 * 3 + 1.
TEST_F(Images, LabelsAreScaledAsTheHeaderSays)
{
  Header header = small;
  header.slope = 2.F;
  header.intercept = 1.F;
  const BodyPointer body =
    create({"Image/File=" + write("a.nii", make_nifti(header, small_labels)),
            "Image/Labels=3: brain; 5: skeleton; 7: lung; 1: none"});
  EXPECT_EQ(body->part_at({0., 0., 0.}), 0);
  EXPECT_EQ(body->part_at({0., 0.002, 0.}), LabelGrid::outside);
  EXPECT_EQ(body->part_at({0., 0.004, 0.}), 1);
  EXPECT_EQ(body->part_at({0.003, 0.002, 0.004}), 2);
}

TEST_F(Images, PlacedImagesKeepTheirLabels)
{
  const BodyPointer body =
    create({"Image/File=" + write("a.nii", make_nifti(small, small_labels)),
            "Image/Labels=1: brain; 2-3: skeleton",
            "Rotation=0, 0, 90",
            "Scale=10",
            "Shift=1, 2, 3"});
  EXPECT_EQ(body->part_at({1. - 0.04, 2., 3.}), 1);
  EXPECT_EQ(body->part_at({1., 2., 3.}), 0);
  EXPECT_LT(body->surface()->value({1. - 0.04, 2., 3.}), 0.);
}

TEST_F(Images, IntegersOf64BitsAreRead)
{
  Header header = small;
  header.bits = 64;
  for (const short type : {1024, 1280})
  {
    header.type = type;
    const std::vector<std::int64_t> labels(small_labels.begin(),
                                           small_labels.end());
    const BodyPointer body =
      create({"Image/File=" + write("a.nii", make_nifti(header, labels)),
              "Image/Labels=1: brain; 2-3: skeleton"});
    EXPECT_EQ(body->part_at({0., 0., 0.}), 0);
    EXPECT_EQ(body->part_at({0., 0.004, 0.}), 1);
  }
}

TEST_F(Images, CompressedContentIsReadUnderAnyName)
{
  const std::string whole = make_nifti(small, small_labels);
  for (const std::string &file :
       {write_compressed("compressed.nii", whole), write("a.nii.gz", whole)})
    EXPECT_EQ(create({"Image/File=" + file, table})->part_at({0., 0.004, 0.}),
              1);
  // Half of a compressed file.
  const Header header{{{20, 20, 20}}};
  std::mt19937 generator(3);
  std::vector<short> labels;
  for (unsigned int i = 0; i < 8000; ++i)
    labels.push_back(static_cast<short>(1 + generator() % 3));
  write_compressed("large.nii.gz", make_nifti(header, labels));
  std::ostringstream bytes;
  bytes << std::ifstream(folder_ / "large.nii.gz", std::ios::binary).rdbuf();
  const std::string cut = bytes.str().substr(0, bytes.str().size() / 2);
  const std::string message =
    refusal({"Image/File=" + write("cut.nii.gz", cut), table});
  EXPECT_NE(message.find("it is cut: it has "), std::string::npos) << message;
  EXPECT_NE(message.find("of the 16000 bytes"), std::string::npos) << message;
}

// Which side is the front, and what the header says twice or not at all.
TEST_F(Images, TheHeaderIsSaidWhereItIsNotPlain)
{
  for (const auto &[width, unit, words] :
       {std::tuple{0.F, '\2', "the front of its header (+y) is +x"},
        std::tuple{0.F, '\0', "no unit of length; mm is taken"},
        std::tuple{5.F, '\2', "5 x 5 x 5 (pixdim), but of 2 x 3 x 4 by"},
        std::tuple{1.F, '\2', "not set (pixdim), they are 2 x 3 x 4 by"}})
  {
    std::string bytes = make_nifti(small, small_labels);
    for (const unsigned int place : {80, 84, 88})
      if (width > 0.F)
        std::memcpy(&bytes[place], &width, sizeof(width));
    bytes[123] = unit;
    const std::string file = "Image/File=" + write("a.nii", bytes);
    const auto said = create({file, table})->remarks();
    EXPECT_EQ(said.size(), width == 0.F && unit == '\2' ? 1u : 2u);
    EXPECT_NE(said.front().find(words), std::string::npos) << said.front();
    EXPECT_EQ(said.front().find("WARNING: ") == 0, width == 5.F);
  }
}

TEST_F(Images, ThePositionsComeFromTheFormThatSpansSpace)
{
  // The matrix of zeros is named by its code as well.
  Header header = small;
  header.form = Form::quaternion;
  std::string bytes = make_nifti(header, small_labels);
  bytes.replace(280, 48, std::string(48, '\0'));
  bytes[254] = 1;
  const BodyPointer body =
    create({"Image/File=" + write("a.nii", bytes), table});
  EXPECT_EQ(body->part_at({0., 0.004, 0.}), 1);
  EXPECT_EQ(body->part_at({0., -0.004, 0.}), LabelGrid::outside);
  ASSERT_EQ(body->remarks().size(), 2u);
  EXPECT_NE(body->remarks()[0].find("its qform places the voxels"),
            std::string::npos);

  header.form = Form::none;
  const BodyPointer unknown = create(
    {"Image/File=" + write("b.nii", make_nifti(header, small_labels)), table});
  ASSERT_EQ(unknown->remarks().size(), 2u);
  EXPECT_EQ(unknown->remarks()[0].find("WARNING: "), 0u);
  EXPECT_NE(unknown->remarks()[0].find("left and right are unknown"),
            std::string::npos);
}

TEST_F(Images, ElementsAreTheVoxelsInAnyStorageOrder)
{
  for (const StorageOrder &order : {StorageOrder{{{0, 1, 2}}, {{1, 1, 1}}},
                                    StorageOrder{{{0, 1, 2}}, {{-1, 1, 1}}},
                                    StorageOrder{{{2, 1, 0}}, {{1, -1, 1}}}})
  {
    const BodyPointer body =
      create({"Image/File=" + write("a.nii", make_box(order)),
              "Image/Labels=1: brain; 2: skeleton"});
    const auto box = body->surface()->bounding_box();
    const Point<3> lower(-0.0005, -0.0055, -0.0005);
    const Point<3> upper(0.0035, 0.0005, 0.0015);
    EXPECT_LT(box.get_boundary_points().first.distance(lower), 1e-9);
    EXPECT_LT(box.get_boundary_points().second.distance(upper), 1e-9);
    for (const auto &[spacing, n_inner, n_all] :
         {std::tuple<double, int, int>{0.001, 8, 48}, {0.0005, 64, 384}})
    {
      LabelGrid grid = make_grid(box, spacing);
      body->fill(grid);
      EXPECT_EQ(std::count(grid.labels.begin(), grid.labels.end(), 1), n_inner);
      EXPECT_EQ(std::count(grid.labels.begin(), grid.labels.end(), 0),
                n_all - n_inner);
    }
    // Between two voxels the one towards +x, +y, +z counts.
    EXPECT_EQ(body->part_at({0.0005, -0.001, 0.}), 1);
    EXPECT_EQ(body->part_at({0.001, -0.0005, 0.}), 0);
    EXPECT_EQ(body->part_at({0.0025, -0.001, 0.}), 0);
  }
}

TEST_F(Images, OneVoxelIsABody)
{
  const Header one{{{1, 1, 1}}};
  const BodyPointer body = create(
    {"Image/File=" + write("a.nii", make_nifti(one, std::vector<short>{7})),
     "Image/Labels=7: lung"});
  EXPECT_LT(body->surface()->value({0., 0., 0.}), 0.);
  EXPECT_GT(body->surface()->value({0.0012, 0., 0.}), 0.);
  LabelGrid grid = make_grid(body->surface()->bounding_box(), 0.0005);
  body->fill(grid);
  EXPECT_EQ(std::count(grid.labels.begin(), grid.labels.end(), 0), 8);
}

TEST_F(Images, BadImagesAreRefusedInOneLine)
{
  const std::string good =
    "Image/File=" + write("a.nii", make_nifti(small, small_labels));
  const auto expect = [](const std::string &message, const std::string &part) {
    EXPECT_NE(message.find(part), std::string::npos)
      << "'" << message << "' lacks '" << part << "'";
  };
  expect(refusal({good, "Image/Labels=1: brain; 2: skeleton"}),
         "has voxels with the label 3");
  expect(refusal({good, "Image/Labels=1: none; 2-3: none"}),
         "no voxel belongs to a part");
  expect(refusal({good, "Image/Labels=1 brain"}), "row \"1 brain\"");
  expect(refusal({good, "Image/Labels=x: brain"}), "\"x\" is not a label");
  expect(refusal({good, "Image/Labels=5-2: brain"}), "below its first");
  expect(refusal({good, "Image/Labels=1: brain; 7: lung; 2-7: heart"}),
         "Body/Image/Labels names the label 7 twice: \"7: lung\" and \"2-7: "
         "heart\"");
  expect(refusal({good, "Image/Labels=1: brian"}), "did you mean \"brain\"");
  expect(refusal({good}), "Body/Image/Labels is empty");
  expect(refusal({}), "Body/Image/File is empty");
  expect(refusal({good, "Image/Kind=t1 and brain mask"}),
         "Body/Image/Brain mask is empty");
  expect(refusal({"Image/File=/nowhere/a.nii", table}),
         "there is no such file");
  const std::string whole = make_nifti(small, small_labels);
  expect(
    refusal({"Image/File=" + write("cut.nii", whole.substr(0, 360)), table}),
    "it is cut: it has 8 of the 24 bytes of voxels");
  expect(refusal({"Image/File=" +
                    write_compressed("cut.nii.gz", whole.substr(0, 360)),
                  table}),
         "it is cut: it has 8 of the 24 bytes of voxels");
  expect(refusal({"Image/File=" + write("text.nii", "no image"), table}),
         "its header is none of NIfTI-1");
  expect(refusal({good, "Image/Labels=1: brain; 2-3: skeleton; 7: lung"}),
         "Body/Image/Labels = \"7: lung\" selects no voxel of image \"" +
           (folder_ / "a.nii").string() + "\": its labels are 0, 1, 2, 3");
  std::vector<short> twice = small_labels;
  twice.insert(twice.end(), small_labels.begin(), small_labels.end());
  Header frames = small;
  frames.frames = 2;
  expect(refusal({"Image/File=" + write("two.nii", make_nifti(frames, twice)),
                  table}),
         "one frame");
  Header oblique = small;
  oblique.oblique = 1.F;
  expect(refusal({"Image/File=" +
                    write("oblique.nii", make_nifti(oblique, small_labels)),
                  table}),
         "not at right angles");
  const std::vector<short> negative(12, -1);
  expect(
    refusal(
      {"Image/File=" + write("minus.nii", make_nifti(small, negative)), table}),
    "-1 is not a label");
}

TEST_F(Images, HeadsHaveTheirLayersByTheRules)
{
  // A bright ball of brain with a dark core, dark skull, bright scalp; its
  // mask is the brain.
  constexpr short n = 61;
  std::vector<short> image;
  std::vector<short> mask;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        const double r = Point<3>(i - 30, j - 30, k - 30).norm();
        mask.push_back(r <= 18.);
        image.push_back(r < 4. || (r > 18. && r < 24.) ? 5
                                                       : (r < 28. ? 100 : 0));
      }
  const Header header{{{n, n, n}}};
  const BodyPointer head =
    create({"Image/Kind=t1 and brain mask",
            "Image/File=" + write("t1.nii", make_nifti(header, image)),
            "Image/Brain mask=" + write("mask.nii", make_nifti(header, mask)),
            "Image/Head/Closing radius=0.004",
            "Image/Head/Skull thickness=0.004"});
  const auto tissue_at = [&](const double r) {
    const unsigned char part = head->part_at({0.03, 0.030 + 1e-3 * r, 0.03});
    return part == LabelGrid::outside ? Tissue::none
                                      : head->parts()[part].tissue;
  };
  EXPECT_EQ(tissue_at(0.), Tissue::cerebrospinal_fluid);
  EXPECT_EQ(tissue_at(10.), Tissue::brain);
  EXPECT_EQ(tissue_at(18.), Tissue::brain);
  EXPECT_EQ(tissue_at(20.), Tissue::cerebrospinal_fluid);
  EXPECT_EQ(tissue_at(21.), Tissue::skeleton);
  EXPECT_EQ(tissue_at(23.), Tissue::skeleton);
  EXPECT_EQ(tissue_at(25.), Tissue::soft_tissue);
  EXPECT_EQ(tissue_at(29.), Tissue::none);

  const std::vector<short> nothing(image.size(), 0);
  EXPECT_NE(refusal({"Image/Kind=t1 and brain mask",
                     "Image/File=" + write("t1.nii", make_nifti(header, image)),
                     "Image/Brain mask=" +
                       write("empty.nii", make_nifti(header, nothing))})
              .find("the mask of the brain is empty"),
            std::string::npos);
  EXPECT_NE(refusal({"Image/Kind=t1 and brain mask",
                     "Image/File=" + write("t1.nii", make_nifti(header, image)),
                     "Image/Brain mask=" +
                       write("a.nii", make_nifti(small, small_labels))})
              .find("do not have the same voxels"),
            std::string::npos);
}

TEST_F(Images, VolumesOfVoxelsAreWhatOrgansShouldHave)
{
  const auto references =
    describe({"Image/File=" + write("a.nii", make_nifti(small, small_labels)),
              "Image/Labels=1: hard = skeleton; 2: brain; 3: hard = lung",
              "Scale=2",
              "Rotation=10, 20, 30"})
      .references();
  ASSERT_EQ(references.size(), 2u);
  constexpr double voxel = 8. * 24e-9;
  EXPECT_EQ(references[0].name, "brain");
  EXPECT_NEAR(references[0].volume, 3. * voxel, 1e-15);
  EXPECT_EQ(references[1].name, "hard");
  EXPECT_NEAR(references[1].volume, 7. * voxel, 1e-15);
}

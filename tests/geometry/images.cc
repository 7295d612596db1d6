// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/geometry/shape/grid_distance.h>

#include <gtest/gtest.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <random>

using namespace contrecoup;
using dealii::Point;
using dealii::Tensor;

namespace
{
/// What says where voxels are in space.
enum class Form
{
  matrix,
  quaternion,
  none
};

/// A NIfTI-1 file of 16-bit numbers, in mm, with voxels of these sizes, the
/// first axis to the left (-x of NIfTI), the second to the front, the third up;
/// without a form the first is to the right.
struct Header
{
  std::array<short, 3> size;
  std::array<float, 3> spacing{{1.F, 1.F, 1.F}};
  float oblique = 0.F;
  short frames = 1;
  Form form = Form::matrix;
  std::array<float, 3> place{{0.F, 0.F, 0.F}}; ///< of the first voxel
  char unit = 2;                               ///< 1: m, 2: mm, 3: micrometre
  float slope = 0.F, intercept = 0.F;
};

std::string make_nifti(const Header &h,
                       const std::vector<short> &values,
                       const bool is_pair = false)
{
  std::string bytes(is_pair ? 348 : 352, '\0');
  const auto put = [&](const std::size_t offset, const auto number) {
    std::copy_n(
      reinterpret_cast<const char *>(&number), sizeof(number), &bytes[offset]);
  };
  put(0, 348);
  const short dimensions = h.frames > 1 ? 4 : 3;
  const std::array<short, 5> dim{
    {dimensions, h.size[0], h.size[1], h.size[2], h.frames}};
  for (unsigned int d = 0; d < 5; ++d)
    put(40 + 2 * d, dim[d]);
  put(70, short(4));  // 16-bit integers
  put(72, short(16)); // their bits
  for (unsigned int d = 0; d < 3; ++d)
    put(80 + 4 * d, h.spacing[d]);
  put(108, is_pair ? 0.F : 352.F);
  put(112, h.slope);
  put(116, h.intercept);
  bytes[123] = h.unit;
  put(252, short(h.form == Form::quaternion));
  put(254, short(h.form == Form::matrix));
  // Half a turn around the second axis, and the third one reversed.
  put(76, -1.F);
  put(260, 1.F);
  put(280, -h.spacing[0]);
  put(284, h.oblique);
  put(300, h.spacing[1]);
  put(320, h.spacing[2]);
  for (unsigned int d = 0; d < 3; ++d)
  {
    put(268 + 4 * d, h.place[d]);
    put(292 + 16 * d, h.place[d]);
  }
  bytes.replace(344, 3, is_pair ? "ni1" : "n+1");
  const std::string data(reinterpret_cast<const char *>(values.data()),
                         2 * values.size());
  return is_pair ? bytes : bytes + data;
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

  static BodyPointer create(const std::vector<std::string> &lines)
  {
    dealii::ParameterHandler prm;
    BodyDescription::declare_parameters(prm);
    std::vector<Assignment> assignments{parse_override("Kind=image")};
    for (const std::string &line : lines)
      assignments.push_back(parse_override(line));
    apply_assignments(assignments, prm);
    BodyDescription description;
    description.parse_parameters(prm);
    return description.create();
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

VoxelMask ball_mask(const unsigned int n, const double radius)
{
  VoxelMask mask{{{n, n, n}}, {{0.1, 0.1, 0.1}}, {}};
  for (unsigned int k = 0; k < n; ++k)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        mask.inside.push_back(
          0.1 * Point<3>(i, j, k).distance(Point<3>(n, n, n) * 0.5) < radius);
  return mask;
}

Tensor<2, 3> diagonal(const double spacing)
{
  Tensor<2, 3> axes;
  for (unsigned int d = 0; d < 3; ++d)
    axes[d][d] = spacing;
  return axes;
}
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


TEST_F(Images, OneVoxelIsABody)
{
  const Header one{{{1, 1, 1}}};
  const BodyPointer body =
    create({"Image/File=" + write("a.nii", make_nifti(one, {7})),
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
  expect(refusal({good, "Image/Labels=1: brian"}), "did you mean \"brain\"");
  expect(refusal({good}), "Body/Image/Labels is empty");
  expect(refusal({}), "Body/Image/File is empty");
  expect(refusal({good, "Image/Kind=t1 and brain mask"}),
         "Body/Image/Brain mask is empty");
  const std::string table = "Image/Labels=1: brain; 2-3: skeleton";
  expect(refusal({"Image/File=/nowhere/a.nii", table}),
         "there is no such file");
  const std::string whole = make_nifti(small, small_labels);
  expect(
    refusal({"Image/File=" + write("cut.nii", whole.substr(0, 360)), table}),
    "cannot be read");
  expect(refusal({"Image/File=" +
                    write_compressed("cut.nii.gz", whole.substr(0, 360)),
                  table}),
         "cannot be read");
  expect(refusal({"Image/File=" + write("text.nii", "no image"), table}),
         "cannot be read");
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


TEST(VoxelMask, DistanceIsThatOfTheNearestVoxel)
{
  VoxelMask mask{{{7, 5, 6}}, {{1., 0.5, 2.}}, {}};
  std::mt19937 generator(4);
  for (unsigned int i = 0; i < 7 * 5 * 6; ++i)
    mask.inside.push_back(generator() % 20 == 0);
  ASSERT_GT(mask.count(), 3u);
  const auto center = [](const unsigned int i) {
    return Point<3>(i % 7, 0.5 * (i / 7 % 5), 2. * (i / 35));
  };
  const std::vector<float> found = distance_to(mask);
  for (unsigned int i = 0; i < found.size(); ++i)
  {
    double least = 1e9;
    for (unsigned int j = 0; j < found.size(); ++j)
      if (mask.inside[j])
        least = std::min(least, center(i).distance(center(j)));
    EXPECT_NEAR(found[i], least, 1e-5);
  }
}


TEST(VoxelMask, HolesGapsAndPieces)
{
  // A box open to the bottom, with a slit in its lid, and a crumb.
  VoxelMask mask{{{12, 12, 12}}, {{1., 1., 1.}}, {}};
  for (unsigned int k = 0; k < 12; ++k)
    for (unsigned int j = 0; j < 12; ++j)
      for (unsigned int i = 0; i < 12; ++i)
      {
        const bool in_box = i >= 2 && i <= 9 && j >= 2 && j <= 9 && k <= 8;
        const bool in_wall = i == 2 || i == 9 || j == 2 || j == 9 || k == 8;
        const bool in_slit = k == 8 && i == 5 && j >= 3 && j <= 8;
        mask.inside.push_back((in_box && in_wall && !in_slit) ||
                              (i == 11 && j == 11 && k == 11));
      }
  const VoxelMask walls = largest_piece(mask);
  EXPECT_EQ(walls.count(), mask.count() - 1);
  EXPECT_EQ(with_filled_holes(walls).count(), walls.count());
  const VoxelMask shut = closed(walls, 2.5);
  EXPECT_EQ(shut.inside[5 + 12 * (5 + 12 * 8)], 1);
  EXPECT_EQ(with_filled_holes(shut).inside[6 + 12 * (6 + 12 * 1)], 1);
  EXPECT_EQ(with_filled_holes(shut).count(), 8u * 8u * 9u);
}


TEST(GridDistance, IsCloseToABallAndNeverTooLarge)
{
  const double radius = 0.8;
  const VoxelMask mask = ball_mask(24, radius);
  const GridDistance shape(mask, diagonal(0.1), Tensor<1, 3>());
  const Point<3> center(1.2, 1.2, 1.2);
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> place(-1., 3.4);
  const auto sample = [&]() {
    return Point<3>(place(generator), place(generator), place(generator));
  };
  for (unsigned int i = 0; i < 500; ++i)
  {
    const Point<3> p = sample();
    const double exact = p.distance(center) - radius;
    EXPECT_LE(std::abs(shape.value(p)), std::abs(exact) + 0.1) << p;
    if (std::abs(exact) > 0.1)
    {
      EXPECT_EQ(shape.value(p) > 0., exact > 0.) << p;
    }
    if (exact > 0.1 && exact < 0.3)
    {
      EXPECT_GT(shape.normal(p) * (p - center) / p.distance(center), 0.8) << p;
    }
    for (const Point<3> &q : {sample(), p + 0.01 * (sample() - p)})
      EXPECT_LE(std::abs(shape.value(p) - shape.value(q)),
                p.distance(q) * (1. + 1e-6) + 1e-6);
    EXPECT_LT((shape.gradient(p) - shape.Shape::gradient(p)).norm(), 0.05) << p;
  }
  for (unsigned int i = 0; i < mask.inside.size(); ++i)
  {
    const Point<3> p(0.1 * (i % 24), 0.1 * (i / 24 % 24), 0.1 * (i / 576));
    EXPECT_EQ(shape.value(p) < 0., mask.inside[i] == 1);
  }
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/output/field_output.h>

#include <gtest/gtest.h>

#include <filesystem>

using namespace contrecoup::io;

namespace
{
/// One patch on the unit cube with density x + 10 y + 100 z.
/// @param stretch if not zero, each point has a place of its own, stretched
/// along x
template <int dim>
FieldOutput<dim> one_patch(const unsigned int n, const double stretch = 0.)
{
  FieldOutput<dim> output({{"density", "kg/m^3"}, {"velocity", "m/s", true}});
  EXPECT_EQ(output.n_components(), 1 + dim);
  auto patch = output.make_patch(n, stretch != 0.);
  for (unsigned int v = 0; v < (1u << dim); ++v)
    for (unsigned int d = 0; d < dim; ++d)
      patch.vertices[v][d] = (v >> d) & 1u;
  const unsigned int n_points = patch.data.n_cols();
  for (unsigned int point = 0; point < n_points; ++point)
  {
    unsigned int rest = point;
    float weight = 1.F;
    for (unsigned int d = 0; d < dim; ++d, rest /= n + 1, weight *= 10.F)
    {
      const float x =
        static_cast<float>(rest % (n + 1)) / static_cast<float>(n);
      patch.data(0, point) += weight * x;
      if (stretch != 0.)
        patch.data(1 + dim + d, point) = d == 0 ? stretch * x : x;
    }
  }
  output.add_patch(std::move(patch));
  return output;
}
} // namespace

TEST(FieldOutput, WritesPatchesOfEveryDimension)
{
  std::filesystem::create_directories("vtu");
  EXPECT_EQ(one_patch<1>(4).write_vtu("vtu", "line", 7, MPI_COMM_SELF),
            "line_0007.vtu");
  one_patch<2>(3).write_vtu("vtu", "square", 0, MPI_COMM_SELF);
  one_patch<3>(2).write_vtu("vtu", "cube", 0, MPI_COMM_SELF);
  const auto counts = [](const std::string &file) {
    const std::string text = read_file("vtu/" + file);
    const std::size_t begin = text.find("NumberOfPoints");
    return text.substr(begin, text.find('>', begin) - begin);
  };
  EXPECT_EQ(counts("line_0007.vtu"),
            "NumberOfPoints=\"5\" NumberOfCells=\"4\" ");
  EXPECT_EQ(counts("square_0000.vtu"),
            "NumberOfPoints=\"16\" NumberOfCells=\"9\" ");
  EXPECT_EQ(counts("cube_0000.vtu"),
            "NumberOfPoints=\"27\" NumberOfCells=\"8\" ");
  const std::string text = read_file("vtu/cube_0000.vtu");
  EXPECT_NE(text.find("Name=\"density\""), std::string::npos);
  EXPECT_NE(text.find("Name=\"velocity\" NumberOfComponents=\"3\""),
            std::string::npos);
  EXPECT_NE(text.find("units=\"kg/m^3\""), std::string::npos);
  EXPECT_NE(text.find("<InformationKey name=\"UNITS_LABEL\" "
                      "location=\"vtkDataArray\">m/s</InformationKey>"
                      "</DataArray>"),
            std::string::npos);
}

TEST(FieldOutput, TheSameFieldsGiveTheSameBytes)
{
  std::filesystem::create_directories("vtu");
  one_patch<2>(3).write_vtu("vtu", "one", 0, MPI_COMM_SELF);
  one_patch<2>(3).write_vtu("vtu", "two", 0, MPI_COMM_SELF);
  EXPECT_EQ(read_file("vtu/one_0000.vtu"), read_file("vtu/two_0000.vtu"));
}

TEST(FieldOutput, PointsMayHavePlacesOfTheirOwn)
{
  std::filesystem::create_directories("vtu");
  one_patch<2>(2).write_vtu("vtu", "corners", 0, MPI_COMM_SELF);
  one_patch<2>(2, 1.).write_vtu("vtu", "points", 0, MPI_COMM_SELF);
  one_patch<2>(2, 2.).write_vtu("vtu", "stretched", 0, MPI_COMM_SELF);
  const std::string corners = read_file("vtu/corners_0000.vtu");
  EXPECT_EQ(read_file("vtu/points_0000.vtu"), corners);
  EXPECT_NE(read_file("vtu/stretched_0000.vtu"), corners);
}

TEST(FieldOutput, WritesHdf5WithXdmf)
{
  std::filesystem::create_directories("vtu");
  EXPECT_EQ(one_patch<3>(2).write_hdf5("vtu", "cube", 1, 0.5, MPI_COMM_SELF),
            "cube_0001.xdmf");
  const std::string text = read_file("vtu/cube_0001.xdmf");
  EXPECT_NE(text.find("cube_0001.h5"), std::string::npos);
  EXPECT_NE(text.find("0.5"), std::string::npos);
  EXPECT_GT(std::filesystem::file_size("vtu/cube_0001.h5"), 27 * 4 * 8u);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/plane_file.h>
#include <contrecoup/io/file/skin_file.h>
#include <contrecoup/io/file/vtk_collection.h>
#include <contrecoup/io/file/vtk_file.h>
#include <contrecoup/io/file/vtk_input.h>

#include <deal.II/base/utilities.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

using namespace contrecoup::io;

namespace
{
PlaneSamples make_plane()
{
  PlaneSamples plane;
  plane.time = 0.5;
  plane.axes = {{0, 2}};
  plane.lower = {{1., -7., 0.25}};
  plane.upper = {{3., -7., 0.75}};
  plane.n_points = {{3, 2}};
  plane.fields = {{"pressure", "Pa", {0., 1., 2., 3., 4., std::nan("")}},
                  {"density", "kg/m^3", {1. / 3., 1., 1., 1., 1., 1.}}};
  return plane;
}


/// A file of arrays of one block, as text in their elements, with these arrays
/// appended as raw bytes.
std::string with_raw_arrays(const std::string &file)
{
  const std::string mark = "format=\"binary\">";
  constexpr std::size_t header_size = 44;
  std::string description, data;
  std::size_t end = 0;
  for (std::size_t begin = file.find(mark); begin != std::string::npos;
       begin = file.find(mark, end))
  {
    description += file.substr(end, begin - end) +
                   "format=\"appended\" offset=\"" +
                   std::to_string(data.size()) + "\">";
    begin += mark.size();
    end = file.find('<', begin);
    for (const std::string &text :
         {file.substr(begin, header_size),
          file.substr(begin + header_size, end - begin - header_size)})
      for (const unsigned char byte : dealii::Utilities::decode_base64(text))
        data += static_cast<char>(byte);
  }
  const std::string close = "</VTKFile>";
  description += file.substr(end, file.find(close) - end);
  return description + "<AppendedData encoding=\"raw\">\n_" + data +
         "\n</AppendedData>\n" + close + "\n";
}


bool holds(const std::string &file, const std::string &text)
{
  return read_file(file).find(text) != std::string::npos;
}
} // namespace


TEST(VtkFiles, PlanesSayWhereTheyAre)
{
  write_plane("plane.vti", make_plane());
  EXPECT_TRUE(holds("plane.vti",
                    "WholeExtent=\"0 2 0 0 0 1\" Origin=\"1 -7 0.25\" "
                    "Spacing=\"1 1 0.5\""));
  EXPECT_TRUE(holds("plane.vti", "Name=\"TimeValue\""));
  EXPECT_TRUE(holds("plane.vti", ">0.5</DataArray>"));
  EXPECT_TRUE(holds("plane.vti",
                    "<InformationKey name=\"UNITS_LABEL\" "
                    "location=\"vtkDataArray\">kg/m^3</InformationKey>"));
  PlaneSamples short_one = make_plane();
  short_one.fields[0].values.pop_back();
  EXPECT_THROW(write_plane("plane.vti", short_one), std::invalid_argument);
}


TEST(VtkFiles, AreReadAsWritten)
{
  write_plane("plane.vti", make_plane());
  const VtkInput plane("plane.vti");
  EXPECT_EQ(plane.names(), (std::vector<std::string>{"pressure", "density"}));
  EXPECT_EQ(plane.extent(), "0 2 0 0 0 1");
  EXPECT_EQ(plane.numbers("density"), make_plane().fields[1].values);
  const auto pressures = plane.numbers("pressure");
  ASSERT_EQ(pressures.size(), 6U);
  EXPECT_EQ(pressures[4], 4.);
  EXPECT_TRUE(std::isnan(pressures[5]));
  EXPECT_THROW(plane.numbers("speed"), contrecoup::InputError);

  // The same arrays, appended as raw bytes.
  write_file("raw.vti", [](std::ostream &out) {
    out << with_raw_arrays(read_file("plane.vti"));
  });
  const VtkInput raw("raw.vti");
  EXPECT_EQ(raw.names(), plane.names());
  EXPECT_EQ(raw.numbers("density"), plane.numbers("density"));
  EXPECT_EQ(raw.numbers("pressure")[4], 4.);

  // More than one compressed block, the last of them shorter.
  std::vector<double> many(300000);
  std::iota(many.begin(), many.end(), 0.25);
  VtkFile file("ImageData", "WholeExtent=\"0 299999 0 0 0 0\"", "");
  file.add("PointData", "many", many);
  file.add("PointData", "none", std::vector<double>());
  file.write("many.vti");
  EXPECT_EQ(VtkInput("many.vti").numbers("many"), many);
  EXPECT_TRUE(VtkInput("many.vti").numbers("none").empty());
}


TEST(VtkFiles, DamagedOnesAreRefused)
{
  write_plane("plane.vti", make_plane());
  const std::string whole = read_file("plane.vti");
  const auto refuses = [](const std::string &content) {
    write_file("cut.vti", [&](std::ostream &out) { out << content; });
    EXPECT_THROW(VtkInput("cut.vti").numbers("density"),
                 contrecoup::InputError);
  };
  for (const std::string &form : {whole, with_raw_arrays(whole)})
    for (std::size_t size = 0; size + 1 < form.size(); size += 7)
      refuses(form.substr(0, size));
  const auto refuses_with = [&](std::string wrong,
                                const std::string &before,
                                const std::string &after) {
    wrong.replace(wrong.rfind(before), before.size(), after);
    refuses(wrong);
  };
  refuses_with(with_raw_arrays(whole), "offset=\"", "offset=\"9");
  refuses_with(whole, "\"binary\">AQ", "\"binary\">Ag");
  refuses_with(whole, "\"binary\">AQAAAAAAAA", "\"binary\">//////////");
  refuses_with(whole, "\"binary\">", "\"binary\">*");
  refuses_with(whole, "UInt64", "UInt32");
  EXPECT_THROW(VtkInput("no such file.vti"), contrecoup::InputError);
}


TEST(VtkFiles, FacetsShareVertices)
{
  // Two triangles of a square, and a line of two pieces.
  const SkinMesh skin = make_skin_mesh(
    {{0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 1, 0, 0, 1, 0}}, false);
  EXPECT_EQ(skin.vertices.size(), 4U * 3U);
  EXPECT_EQ(skin.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(skin.ends, (std::vector<std::int64_t>{3, 6}));
  write_skin("skin.vtp", skin, {{"peak", "Pa", {1.F, 2.F}}}, 0.25);
  EXPECT_TRUE(holds("skin.vtp",
                    "NumberOfPoints=\"4\" NumberOfVerts=\"0\" "
                    "NumberOfLines=\"0\" NumberOfStrips=\"0\" "
                    "NumberOfPolys=\"2\""));
  EXPECT_TRUE(holds("skin.vtp", ">Pa</InformationKey>"));
  EXPECT_THROW(write_skin("skin.vtp", skin, {{"peak", "Pa", {1.F}}}, 0.25),
               std::invalid_argument);

  const SkinMesh lines = make_skin_mesh({{0, 0, 0, 1, 0, 0, 1, 1, 0}}, true);
  write_skin("skin.vtp", lines, {}, 0.25);
  EXPECT_TRUE(holds("skin.vtp", "NumberOfLines=\"1\""));
  EXPECT_TRUE(holds("skin.vtp", "<Lines>"));
}


TEST(VtkFiles, NamesOfNumbers)
{
  VtkFile file("UnstructuredGrid", "", "");
  file.add_names("tissue", {"none", "a < \"b\""});
  file.add("CellData", "tissue", std::vector<unsigned char>{1, 0});
  file.write("names.vtu");
  EXPECT_TRUE(holds("names.vtu",
                    "<FieldData>\n<DataArray type=\"Int64\" "
                    "Name=\"tissue 0: none\" NumberOfTuples=\"1\" "
                    "format=\"ascii\">0</DataArray>\n"));
  EXPECT_TRUE(holds("names.vtu", "Name=\"tissue 1: a &lt; &quot;b&quot;\""));
}


TEST(VtkFiles, CollectionsListFilesTimesAndParts)
{
  write_collection("list.pvd",
                   {{0.1, "", "a.vtu"},
                    {1. / 3., "plane", "b.vti"},
                    {1. / 3., "skin", "b.vtp"}});
  EXPECT_TRUE(holds("list.pvd",
                    "<DataSet timestep=\"0.1\" group=\"\" part=\"0\" "
                    "file=\"a.vtu\"/>"));
  EXPECT_TRUE(holds("list.pvd",
                    "<DataSet timestep=\"0.333333333333\" group=\"\" "
                    "part=\"0\" name=\"plane\" file=\"b.vti\"/>"));
  EXPECT_TRUE(holds("list.pvd", "part=\"1\" name=\"skin\" file=\"b.vtp\"/>"));
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/hdf5_handle.h>
#include <contrecoup/io/file/hdf5_input.h>
#include <contrecoup/io/output/load_reader.h>
#include <contrecoup/io/output/load_series.h>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>

using namespace contrecoup::io;

namespace
{
/// Two triangles of a square.
LoadFile::Facets make_facets()
{
  LoadFile::Facets facets;
  facets.centroids = {0.7, 0.3, 0., 0.3, 0.7, 0.};
  facets.normals = {0., 0., 1., 0., 0., 1.};
  facets.areas = {0.5, 0.5};
  facets.corners = make_skin_mesh(
    {{0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 1, 0, 0, 1, 0}}, false);
  return facets;
}


void write_loads(const std::string &path, const LoadFile::Facets &facets)
{
  LoadFile file(path);
  file.create(facets, {{"application", "blast"}});
  file.append({0.1, 0.3}, {1.F, 2.F, 3.F, 4.F});
  for (const char *const name : {"peak", "impulse", "arrival", "duration"})
    file.write(name, {5., 6.});
}


/// A text attribute of a dataset.
std::string
attribute(const Hdf5Handle &file, const char *dataset, const char *name)
{
  const Hdf5Handle data(H5Dopen2(file, dataset, H5P_DEFAULT), H5Dclose);
  const Hdf5Handle text(H5Aopen(data, name, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(text), H5Tclose);
  std::string value(H5Tget_size(type), '\0');
  EXPECT_GE(H5Aread(text, type, &value[0]), 0) << dataset << " " << name;
  return value.c_str();
}


/// HDF5's labels of the dimensions of a dataset.
std::vector<std::string> dimensions(const Hdf5Handle &file, const char *dataset)
{
  const Hdf5Handle data(H5Dopen2(file, dataset, H5P_DEFAULT), H5Dclose);
  const Hdf5Handle text(H5Aopen(data, "DIMENSION_LABELS", H5P_DEFAULT),
                        H5Aclose);
  const Hdf5Handle space(H5Aget_space(text), H5Sclose);
  const Hdf5Handle type(H5Aget_type(text), H5Tclose);
  std::vector<char *> words(H5Sget_simple_extent_npoints(space));
  EXPECT_GE(H5Aread(text, type, words.data()), 0) << dataset;
  const std::vector<std::string> result(words.begin(), words.end());
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, words.data());
  return result;
}
} // namespace


TEST(LoadFile, EachDatasetSaysWhatItIs)
{
  write_loads("loads.h5", make_facets());
  const Hdf5Handle file(H5Fopen("loads.h5", H5F_ACC_RDONLY, H5P_DEFAULT),
                        H5Fclose);
  for (const char *const name : {"centroid",
                                 "normal",
                                 "area",
                                 "vertex",
                                 "connectivity",
                                 "time",
                                 "overpressure",
                                 "peak",
                                 "impulse",
                                 "arrival",
                                 "duration"})
  {
    EXPECT_FALSE(attribute(file, name, "units").empty()) << name;
    EXPECT_FALSE(attribute(file, name, "description").empty()) << name;
    EXPECT_FALSE(dimensions(file, name).empty()) << name;
  }
  EXPECT_EQ(attribute(file, "overpressure", "units"), "Pa");
  EXPECT_EQ(attribute(file, "overpressure", "axes"), "facet x time");
  EXPECT_EQ(dimensions(file, "overpressure"),
            (std::vector<std::string>{"facet", "time"}));
  EXPECT_EQ(attribute(file, "area", "units"), "m^2");
}


TEST(LoadFile, LinesHaveALength)
{
  LoadFile::Facets facets = make_facets();
  facets.corners =
    make_skin_mesh({{0, 0, 0, 1, 0, 0}, {1, 0, 0, 1, 1, 0}}, true);
  write_loads("lines.h5", facets);
  const Hdf5Handle file(H5Fopen("lines.h5", H5F_ACC_RDONLY, H5P_DEFAULT),
                        H5Fclose);
  EXPECT_EQ(attribute(file, "area", "units"), "m");
  EXPECT_EQ(Hdf5Input("lines.h5").numbers("connectivity"),
            (std::vector<double>{2, 2, 0, 1, 2, 2, 1, 2}));
}


TEST(LoadFile, IsReadAsWritten)
{
  write_loads("loads.h5", make_facets());
  const LoadReader loads("loads.h5");
  EXPECT_EQ(loads.n_facets(), 2U);
  EXPECT_EQ(loads.times(), (std::vector<double>{0.1, 0.3}));
  EXPECT_EQ(loads.read(0, 2), (std::vector<float>{1.F, 3.F, 2.F, 4.F}));
  const Hdf5Input file("loads.h5");
  EXPECT_EQ(file.numbers("vertex").size(), 12U);
  EXPECT_EQ(file.numbers("connectivity"),
            (std::vector<double>{3, 3, 0, 1, 2, 3, 3, 0, 2, 3}));
}


// A phase that a checkpoint cut off ends later.
TEST(LoadFile, NumbersReplaceThoseBefore)
{
  write_loads("loads.h5", make_facets());
  LoadFile file("loads.h5");
  file.write(
    LoadFile::Numbers{{"loads_ear_peak", 1.}, {"loads_ear_cut_off", 1.}});
  file.write(LoadFile::Numbers{{"loads_ear_peak", 2.}});
  const Hdf5Input input("loads.h5");
  EXPECT_EQ(input.number("loads_ear_peak"), 2.);
  EXPECT_FALSE(input.has_attribute("loads_ear_cut_off"));
  EXPECT_TRUE(input.has_attribute("application"));
}


TEST(LoadFile, TheSeriesListsEachSample)
{
  write_loads("loads.h5", make_facets());
  write_load_series("loads.h5");
  const std::string text = read_file("loads.xdmf");
  for (const char *const part :
       {"<Time Value=\"0.1",
        "<Time Value=\"0.3",
        "NumberOfElements=\"2\"",
        "Dimensions=\"10\" NumberType=\"Int\" Precision=\"4\" "
        "Format=\"HDF\">loads.h5:/connectivity<",
        "Dimensions=\"4 3\" NumberType=\"Float\" Precision=\"4\" "
        "Format=\"HDF\">loads.h5:/vertex<",
        ">0 0 1 1 2 1</DataItem>",
        ">0 1 1 1 2 1</DataItem>",
        "Dimensions=\"2 2\" NumberType=\"Float\" Precision=\"4\" "
        "Format=\"HDF\">loads.h5:/overpressure<",
        ">loads.h5:/peak<"})
    EXPECT_NE(text.find(part), std::string::npos) << part;

  // Nothing can be shown of facets without corners.
  LoadFile::Facets points = make_facets();
  points.corners = {};
  write_loads("points.h5", points);
  write_load_series("points.h5");
  EXPECT_FALSE(std::filesystem::exists("points.xdmf"));
  EXPECT_THROW(write_load_series("none.h5"), contrecoup::InputError);
}


TEST(LoadFile, AnotherProgramsLockIsToldFromDamage)
{
  const std::string path = "locked_loads.h5";
  write_loads(path, make_facets());
  const int file = ::open(path.c_str(), O_RDONLY);
  ASSERT_EQ(::flock(file, LOCK_EX), 0);
  // Without locks the file is read.
  const char *const locks = std::getenv("HDF5_USE_FILE_LOCKING");
  try
  {
    const Hdf5Input input(path);
    EXPECT_NE(locks, nullptr);
  }
  catch (const contrecoup::InputError &error)
  {
    EXPECT_NE(std::string(error.what()).find("locked by another program"),
              std::string::npos)
      << error.what();
  }
  ::close(file);
  EXPECT_NO_THROW(const Hdf5Input input(path));
  std::filesystem::remove(path);
}

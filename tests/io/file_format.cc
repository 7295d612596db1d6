// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/application/check_file.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/file/hdf5_handle.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/io/output/load_reader.h>
#include <contrecoup/io/output/manifest.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>

using namespace contrecoup;
using namespace contrecoup::io;

namespace
{
std::string refusal(const std::function<void()> &read)
{
  try
  {
    read();
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "read";
}


std::string newer(const std::string &file, const FileFormat &format)
{
  return "\"" + file + "\" has format " + std::to_string(format.number + 1) +
         ", this program reads up to " + std::to_string(format.number);
}


void write(const std::string &file, const nlohmann::ordered_json &content)
{
  write_file(file, [&](std::ostream &out) { out << content; });
}


/// Writes a file of loads with this attribute in place of its own.
void write_loads(const std::string &path, const std::string &format)
{
  LoadFile::Facets facets;
  facets.centroids = {0., 0., 0.};
  facets.normals = {0., 0., 1.};
  facets.areas = {1.};
  facets.corners = make_skin_mesh({{0, 0, 0, 1, 0, 0, 1, 1, 0}}, false);
  LoadFile(path).create(facets, {});
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT),
                        H5Fclose);
  const Hdf5Handle attribute(H5Aopen(file, "format", H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  EXPECT_EQ(H5Tget_size(type), format.size() + 1);
  EXPECT_GE(H5Awrite(attribute, type, format.c_str()), 0);
}
} // namespace


TEST(FileFormat, ANewerNumberOfJsonIsRefusedAndOthersAreRead)
{
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/some.json";
  EXPECT_TRUE(read_json(file, formats::summary).is_null());
  for (const int number : {0, 1})
  {
    write(file, {{"format", number}, {"a", 1}});
    EXPECT_EQ(read_json(file, formats::summary).at("a"), 1);
  }
  write(file, {{"a", 1}});
  EXPECT_EQ(read_json(file, formats::summary).at("a"), 1);
  for (const FileFormat &format : {formats::summary, formats::checkpoint})
  {
    write(file, {{"format", format.number + 1}});
    EXPECT_EQ(refusal([&]() { read_json(file, format); }), newer(file, format));
  }
  write(file, {{"format", 18446744073709551615U}});
  EXPECT_NE(refusal([&]() { read_json(file, formats::summary); }), "read");
}


TEST(FileFormat, NewerLoadsAreRefused)
{
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/loads.h5";
  write_loads(file, format_text(formats::loads));
  EXPECT_EQ(LoadReader(file).n_facets(), 1U);
  write_loads(file, "contrecoup loads 2");
  EXPECT_EQ(refusal([&]() { LoadReader reader(file); }),
            newer(file, formats::loads));
  for (const char *other : {"contrecoup loads x", "contrecoup roads 1"})
  {
    write_loads(file, other);
    EXPECT_EQ(refusal([&]() { LoadReader reader(file); }),
              "\"" + file + "\" has the format \"" + other +
                "\", not \"contrecoup loads 1\"");
  }
}


TEST(FileFormat, ANewerManifestIsRefused)
{
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/manifest.json";
  Manifest(folder.path()).begin("blast", {}, {});
  EXPECT_TRUE(Manifest(folder.path()).exists());
  auto content = read_json(file, formats::manifest);
  content["format"] = formats::manifest.number + 1;
  write(file, content);
  EXPECT_EQ(refusal([&]() { Manifest manifest(folder.path()); }),
            newer(file, formats::manifest));
}


TEST(FileFormat, ANewerForecastIsRefused)
{
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/check.json";
  setenv("CONTRECOUP_CHECK_FILE", file.c_str(), 1);
  CostEstimate cost;
  cost.steps = 7.;
  write_check_file({"blast", cost, {}, {{"coarse", cost}}});
  unsetenv("CONTRECOUP_CHECK_FILE");
  EXPECT_EQ(read_check_file(file).application, "blast");
  EXPECT_EQ(read_check_file(file).cost.steps, 7.);
  EXPECT_EQ(read_check_file(file).cost.cells, 0.);
  auto content = read_json(file, formats::forecast);
  // An unknown value is no number for other programs.
  for (const Json &row : {content, content["stages"][0]})
    EXPECT_TRUE(row["steps"] == 7. && row["cells"].is_null()) << row;
  content["format"] = formats::forecast.number + 1;
  write(file, content);
  EXPECT_EQ(refusal([&]() { read_check_file(file); }),
            newer(file, formats::forecast));
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/shape/ply_file.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace contrecoup;

namespace
{
/// Reads this content as a file, in mm.
TriangleMesh read(const std::string &content)
{
  const std::string file = (std::filesystem::temp_directory_path() /
                            ("contrecoup_" + std::to_string(getpid()) + ".ply"))
                             .string();
  std::ofstream(file, std::ios::binary) << content;
  const auto remove = [](const std::string *name) {
    std::filesystem::remove(*name);
  };
  const std::unique_ptr<const std::string, decltype(remove)> guard(&file,
                                                                   remove);
  return read_ply(file, 1e-3);
}

/// A square and a triangle on its side; vertices have a colour before z.
std::string header(const std::string &format)
{
  return "ply\nformat " + format +
         " 1.0\ncomment made by hand\nelement vertex 5\nproperty double x\n"
         "property short y\nproperty uchar red\nproperty float z\n"
         "element edge 1\nproperty int a\nproperty list uchar float b\n"
         "element face 2\nproperty list ushort uint vertex_index\n"
         "end_header\n";
}

const std::string ascii = "0 0 255 0\n10 0 0 0\n10 10 0 0\n0 10 0 0\n"
                          "2.5 -3 0 1e1\n7 2 1.5 2.5\n4 0 1 2 3\n3 0 1 4\n";

template <typename Number>
void put(std::string &bytes, const Number number, const bool turned)
{
  char raw[sizeof(Number)];
  std::copy_n(reinterpret_cast<const char *>(&number), sizeof(Number), raw);
  if (turned)
    std::reverse(raw, raw + sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

std::string binary(const bool turned)
{
  std::string bytes;
  const double x[] = {0., 10., 10., 0., 2.5};
  const short y[] = {0, 0, 10, 10, -3};
  for (unsigned int i = 0; i < 5; ++i)
  {
    put(bytes, x[i], turned);
    put(bytes, y[i], turned);
    put(bytes, std::uint8_t(255), turned);
    put(bytes, i == 4 ? 10.F : 0.F, turned);
  }
  put(bytes, std::int32_t(-7), turned);
  put(bytes, std::uint8_t(1), turned);
  put(bytes, 1.5F, turned);
  for (const auto &face : {std::vector<std::uint32_t>{0, 1, 2, 3},
                           std::vector<std::uint32_t>{0, 1, 4}})
  {
    put(bytes, static_cast<std::uint16_t>(face.size()), turned);
    for (const std::uint32_t corner : face)
      put(bytes, corner, turned);
  }
  return bytes;
}

std::string refusal(const std::string &content)
{
  try
  {
    read(content);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}
} // namespace


TEST(PlyFile, AllFormats)
{
  for (const std::string &content :
       {header("ascii") + ascii,
        header("binary_little_endian") + binary(false),
        header("binary_big_endian") + binary(true)})
  {
    const TriangleMesh mesh = read(content);
    ASSERT_EQ(mesh.vertices.size(), 5u);
    EXPECT_NEAR(mesh.vertices[4].distance({2.5e-3, -3e-3, 10e-3}), 0., 1e-12);
    EXPECT_EQ(mesh.triangles,
              (std::vector<TriangleMesh::Triangle>{
                {{0, 1, 2}}, {{0, 2, 3}}, {{0, 1, 4}}}));
  }
}


TEST(PlyFile, RefusesDamage)
{
  const std::string whole = header("binary_little_endian") + binary(false);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW(read(whole.substr(0, size)), InputError) << size;
  const auto changed = [](const std::string &from, const std::string &to) {
    std::string text = header("ascii") + ascii;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_NE(refusal(changed("3 0 1 4", "3 0 1 5")).find("no vertex"),
            std::string::npos);
  EXPECT_NE(refusal(changed("3 0 1 4", "4000000000 0 1 4")).find("counts"),
            std::string::npos);
  EXPECT_NE(refusal(changed("face 2", "face 1e1")).find("number"),
            std::string::npos);
  EXPECT_NE(refusal(changed("double x", "double w")).find("no x"),
            std::string::npos);
  EXPECT_NE(refusal(changed("short", "shirt")).find("no type"),
            std::string::npos);
  EXPECT_NE(refusal(changed("1e1", "ten")).find("no number"),
            std::string::npos);
}

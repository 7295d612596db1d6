// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/placement.h>
#include <contrecoup/geometry/shape/triangulated_surface.h>

#include "described_body.h"
#include "spheres.h"
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

using namespace contrecoup;
using dealii::Point;
using dealii::Tensor;

namespace
{
void write_ascii_stl(const TriangleMesh &mesh, std::ostream &out)
{
  out << "solid thing\n";
  for (const auto &triangle : mesh.triangles)
  {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t vertex : triangle)
      out << "vertex " << mesh.vertices[vertex] << "\n";
    out << "endloop\nendfacet\n";
  }
  out << "endsolid thing\n";
}

void write_binary_stl(const TriangleMesh &mesh, std::ostream &out)
{
  out << std::string(80, ' ');
  const std::uint32_t count = mesh.triangles.size();
  out.write(reinterpret_cast<const char *>(&count), 4);
  for (const auto &triangle : mesh.triangles)
  {
    std::array<float, 12> values{};
    for (unsigned int v = 0; v < 3; ++v)
      for (unsigned int d = 0; d < 3; ++d)
        values[3 + 3 * v + d] = mesh.vertices[triangle[v]][d];
    out.write(reinterpret_cast<const char *>(values.data()), 48);
    out.write("\0\0", 2);
  }
}

void write_obj(const TriangleMesh &mesh, std::ostream &out)
{
  for (const Point<3> &vertex : mesh.vertices)
    out << "v " << vertex << "\n";
  for (const auto &t : mesh.triangles)
    out << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
}

void write_ply(const TriangleMesh &mesh, std::ostream &out)
{
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertices.size()
      << "\nproperty float x\nproperty float y\nproperty float z\n"
         "element face "
      << mesh.triangles.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point<3> &vertex : mesh.vertices)
    out << vertex << "\n";
  for (const auto &t : mesh.triangles)
    out << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
}

class SurfaceFile : public BodyFiles
{
protected:
  template <typename Writer>
  std::string write(const std::string &name,
                    const TriangleMesh &mesh,
                    const Writer &writer) const
  {
    std::ofstream out(folder_ / name, std::ios::binary);
    writer(mesh, out);
    return folder_ / name;
  }

  /// A body from a surface.
  BodyPointer create(const std::string &file,
                     const std::vector<std::string> &more = {}) const override
  {
    return described_body({"Kind=surface", "Surface/File=" + file}, more);
  }
};
} // namespace


TEST_F(SurfaceFile, AllFormatsGiveTheSameBody)
{
  const TriangleMesh sphere = make_sphere(16, Point<3>(0.1, 0.2, 0.3), 0.5);
  const std::vector<std::string> files{write("a.stl", sphere, write_ascii_stl),
                                       write("b.stl", sphere, write_binary_stl),
                                       write("c.obj", sphere, write_obj),
                                       write("d.ply", sphere, write_ply)};
  for (const std::string &file : files)
  {
    const BodyPointer body = create(file, {"Surface/Tissue=gelatin"});
    ASSERT_EQ(body->parts().size(), 1u);
    EXPECT_EQ(body->parts()[0].tissue, Tissue::gelatin);
    EXPECT_EQ(body->remarks().size(), 1u) << body->remarks().back();
    for (const Point<3> &p : {Point<3>(0.1, 0.2, 0.3),
                              Point<3>(0.7, 0.2, 0.1),
                              Point<3>(0.1, 0.65, 0.3)})
      EXPECT_NEAR(
        body->surface()->value(p), TriangulatedSurface(sphere).value(p), 1e-6)
        << file;
  }
}


TEST_F(SurfaceFile, AsciiStlHasItsWordsInAnyCase)
{
  const TriangleMesh sphere = make_sphere(8, Point<3>(0.1, 0.2, 0.3), 0.5);
  std::ostringstream lower;
  write_ascii_stl(sphere, lower);
  std::string text = lower.str();
  const auto expect_sphere = [&](const std::string &content) {
    const auto writer = [&](const TriangleMesh &, std::ostream &out) {
      out << content;
    };
    const TriangleMesh read = read_surface(write("a.stl", sphere, writer), 1.);
    EXPECT_EQ(read.triangles.size(), sphere.triangles.size());
    EXPECT_NEAR(read.volume(), sphere.volume(), 1e-5);
  };
  expect_sphere("\n\n  " + text);
  for (char &letter : text)
    letter = static_cast<char>(std::toupper(letter));
  expect_sphere(text);
  for (std::size_t i = 0; i < text.size(); i += 2)
    text[i] = static_cast<char>(std::tolower(text[i]));
  expect_sphere(text);
  // The name may be any words.
  expect_sphere("solid vertex of a facet" + text.substr(text.find('\n')));
}


TEST_F(SurfaceFile, BinaryStlIsAsLongAsItsHeaderCounts)
{
  const TriangleMesh sphere = make_sphere(8, Point<3>(), 0.5);
  std::ostringstream bytes;
  write_binary_stl(sphere, bytes);
  // Such files may begin as ASCII does.
  const std::string whole = "solid exported" + bytes.str().substr(14);
  const auto file_of = [&](const std::string &content) {
    return write("a.stl", sphere, [&](const TriangleMesh &, std::ostream &out) {
      out << content;
    });
  };
  EXPECT_EQ(read_surface(file_of(whole), 1.).triangles.size(),
            sphere.triangles.size());
  const BodyPointer body = create(file_of(whole + std::string(92, '\0')));
  ASSERT_EQ(body->remarks().size(), 2u);
  EXPECT_EQ(body->remarks()[0],
            "the file has 92 bytes after the 224 triangles that its header "
            "counts; they are not read");
  EXPECT_NE(refusal(file_of(whole.substr(0, whole.size() - 120)))
              .find("it is cut: its header counts 224 triangles, it has 221 of "
                    "them, and 120 bytes are missing"),
            std::string::npos);
}


TEST_F(SurfaceFile, PositionsInMapCoordinatesKeepTheirDigits)
{
  const Point<3> place(502345., 4649776., 124.);
  const TriangleMesh sphere = make_sphere(16, Point<3>(), 0.5);
  const TriangleMesh far = make_sphere(16, place, 0.5);
  const auto precisely = [](const auto &writer) {
    return [&writer](const TriangleMesh &mesh, std::ostream &out) {
      out.precision(14);
      writer(mesh, out);
    };
  };
  for (const std::string &file :
       {write("a.obj", far, precisely(write_obj)),
        write("b.ply", far, precisely(write_ply)),
        write("c.stl", far, precisely(write_ascii_stl))})
  {
    const BodyPointer body = create(file, {"Origin=middle"});
    EXPECT_EQ(body->remarks().size(), 1u) << body->remarks().front();
    for (const Point<3> &p : {Point<3>(), Point<3>(0.3, 0.2, -0.4)})
      EXPECT_NEAR(
        body->surface()->value(p), TriangulatedSurface(sphere).value(p), 1e-7);
  }
  // Single precision there has steps of half a metre.
  EXPECT_NE(refusal(write("d.stl", far, write_binary_stl))
              .find("positions, in single precision, are known to 5.5e+02 mm"),
            std::string::npos);
  // Further on, the shape is there and known roughly.
  const BodyPointer near = create(write(
    "e.stl", make_sphere(16, Point<3>(20000., 0., 0.), 0.5), write_binary_stl));
  EXPECT_EQ(near->remarks()[0].find("WARNING: "), 0u);
}


TEST_F(SurfaceFile, IsRefusedWhereMostTrianglesHaveNoArea)
{
  // Metres without decimals.
  const auto rounded = [](const TriangleMesh &mesh, std::ostream &out) {
    TriangleMesh coarse = mesh;
    for (Point<3> &vertex : coarse.vertices)
      for (unsigned int d = 0; d < 3; ++d)
        vertex[d] = std::round(vertex[d]);
    write_obj(coarse, out);
  };
  EXPECT_NE(refusal(write("a.obj", make_sphere(16, Point<3>(), 1.2), rounded))
              .find("triangles have no area or are given twice"),
            std::string::npos);
}


TEST_F(SurfaceFile, FacesOfObjMayCountFromTheLastVertex)
{
  const auto writer = [](const TriangleMesh &, std::ostream &out) {
    out << "mtllib none.mtl\nv 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 \\\n1 0\r\n"
           "v 0 0 1\nvt 0 0\nf 1/1 3/1 2/1\nf -4 -3 -1\nf 1//1 4//1 3//1\n"
           "f 2 3 4\n";
  };
  const TriangleMesh mesh = read_surface(write("a.obj", {}, writer), 2.);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_NEAR(mesh.volume(), 8. / 6., 1e-12);
  const auto bad = [](const TriangleMesh &, std::ostream &out) {
    out << "v 0 0 0\nv 1 0 0\nv 1,5 0 0\nf 1 2 4\n";
  };
  EXPECT_NE(
    refusal(write("b.obj", {}, bad)).find("line 3: \"1,5\" is no number"),
    std::string::npos);
}


TEST_F(SurfaceFile, IsReadAgainOnceItIsAnother)
{
  const TriangleMesh sphere = make_sphere(16, Point<3>(), 0.5);
  const std::string file = write("a.stl", sphere, write_binary_stl);
  const BodyPointer body = create(file);
  EXPECT_EQ(create(file), body);
  EXPECT_EQ(create(file, {"Shift=1, 0, 0"})->parts().size(), 1U);
  EXPECT_EQ(create(file), body);
  EXPECT_NEAR(
    create(file, {"Scale=2"})->surface()->value(Point<3>()), -1., 0.02);
  EXPECT_NE(create(file, {"Surface/Tissue=gelatin"})->parts()[0].tissue,
            body->parts()[0].tissue);
  write("a.stl", make_sphere(16, Point<3>(1., 0., 0.), 0.5), write_binary_stl);
  EXPECT_NEAR(create(file)->surface()->value(Point<3>(1., 0., 0.)), -0.5, 0.01);
}


TEST_F(SurfaceFile, UnitsScaleRotationAndOriginPlaceIt)
{
  const TriangleMesh sphere = make_sphere(16, Point<3>(100., 20., 30.), 50.);
  const std::string file = write("a.stl", sphere, write_binary_stl);
  const BodyPointer body = create(file,
                                  {"Surface/Unit=cm",
                                   "Scale=2",
                                   "Rotation=0, 0, 90",
                                   "Origin=bottom",
                                   "Shift=1, 2, 3"});
  const auto box = body->surface()->bounding_box();
  EXPECT_NEAR(box.side_length(2), 2., 1e-5);
  EXPECT_NEAR(box.lower_bound(2), 3., 1e-5);
  EXPECT_NEAR(box.center()[0], 1., 1e-5);
  EXPECT_NEAR(box.center()[1], 2., 1e-5);
  EXPECT_NEAR(body->surface()->value({1., 2., 4.}), -1., 0.01);
  const BodyPointer turned =
    create(file, {"Surface/Unit=cm", "Rotation=0, 0, 90"});
  EXPECT_LT(turned->surface()->value({-0.2, 1., 0.3}), -0.4);
}


// A hundred of each, in m.
TEST_F(SurfaceFile, UnitsHaveTheirLengths)
{
  const std::string file =
    write("a.stl", make_sphere(16, Point<3>(), 50.), write_binary_stl);
  for (const auto &[unit, size] : {std::pair<std::string, double>{"m", 100.},
                                   {"cm", 1.},
                                   {"mm", 0.1},
                                   {"inch", 2.54}})
  {
    const BodyPointer body =
      create(file, {"Surface/Unit=" + unit, "Surface/Largest size=200"});
    const auto box = body->surface()->bounding_box();
    EXPECT_NEAR(box.side_length(2), size, 1e-5 * size) << unit;
  }
}


// A person who stands askew in the file is as narrow as one who does not.
TEST_F(SurfaceFile, UnturnedBoxIsThatOfTheNarrowestPose)
{
  const double width[] = {0.3, 0.5, 1.8}; // [m]
  for (const double degrees : {0., 45., 118.})
  {
    const Placement turn(
      1., Tensor<1, 3>({0., 0., degrees * dealii::numbers::PI / 180.}), {});
    TriangleMesh mesh = make_sphere(32, Point<3>(), 0.5);
    for (Point<3> &vertex : mesh.vertices)
    {
      for (unsigned int d = 0; d < 3; ++d)
        vertex[d] *= width[d];
      vertex = turn.apply(vertex);
    }
    const auto box =
      described<BodyDescription>(
        {"Kind=surface",
         "Surface/File=" + write("a.stl", mesh, write_binary_stl)})
        .unturned_box();
    EXPECT_NEAR(std::min(box.side_length(0), box.side_length(1)), 0.3, 0.01)
      << degrees;
    EXPECT_NEAR(box.side_length(2), 1.8, 0.02) << degrees;
  }
}


TEST_F(SurfaceFile, HolesAndCrossingsAreReported)
{
  TriangleMesh mesh = make_sphere(16);
  mesh.triangles.erase(mesh.triangles.begin() + 100);
  append(mesh, make_sphere(16, Point<3>(0.7, 0.3, 0.)));
  const BodyPointer body = create(write("a.stl", mesh, write_binary_stl));
  ASSERT_EQ(body->remarks().size(), 3u);
  EXPECT_NE(body->remarks()[1].find("1 hole(s) were closed"),
            std::string::npos);
  EXPECT_NE(body->remarks()[2].find("pass through each other"),
            std::string::npos);
}


TEST_F(SurfaceFile, BadSurfacesAreRefusedInOneLine)
{
  TriangleMesh half = make_sphere(16);
  half.triangles.resize(half.triangles.size() / 2);
  EXPECT_NE(refusal(write("half.stl", half, write_binary_stl))
              .find("Body/Surface/Largest holes allows 5 %"),
            std::string::npos);
  EXPECT_EQ(refusal(write("half.stl", half, write_binary_stl),
                    {"Surface/Largest holes=0.5"}),
            "");

  TriangleMesh flat;
  flat.vertices = {{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.}, {0., 1., 0.}};
  flat.triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  EXPECT_NE(
    refusal(write("flat.obj", flat, write_obj), {"Surface/Largest holes=1"})
      .find("encloses no volume"),
    std::string::npos);

  EXPECT_NE(refusal("/nowhere/body.stl").find("there is no such file"),
            std::string::npos);
  EXPECT_NE(refusal("").find("Body/Surface/File is empty"), std::string::npos);
  const auto nonsense = [](const TriangleMesh &, std::ostream &out) {
    out << "this is no surface\n";
  };
  EXPECT_NE(refusal(write("text.stl", flat, nonsense)).find("cannot be read"),
            std::string::npos);
  EXPECT_NE(refusal(write("text.xyz", flat, nonsense)).find("cannot be read"),
            std::string::npos);
  flat.triangles.clear();
  EXPECT_NE(refusal(write("points.ply", flat, write_ply)).find("points.ply"),
            std::string::npos);
}

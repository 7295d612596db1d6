// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/geometry/shape/triangle_intersections.h>
#include <contrecoup/geometry/shape/triangle_repair.h>
#include <contrecoup/geometry/shape/triangulated_surface.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

using namespace contrecoup;
using dealii::Point;
using dealii::Tensor;

namespace
{
/// A sphere of n rings, twice as many around.
TriangleMesh make_sphere(const unsigned int n,
                         const Point<3> &center = Point<3>(),
                         const double radius = 1.)
{
  TriangleMesh mesh;
  const unsigned int m = 2 * n;
  const auto at = [&](const unsigned int ring, const unsigned int around) {
    const double theta = M_PI * ring / n;
    const double phi = 2. * M_PI * around / m;
    return center + radius * Point<3>(std::sin(theta) * std::cos(phi),
                                      std::sin(theta) * std::sin(phi),
                                      std::cos(theta));
  };
  mesh.vertices = {at(0, 0), at(n, 0)};
  for (unsigned int ring = 1; ring < n; ++ring)
    for (unsigned int around = 0; around < m; ++around)
      mesh.vertices.push_back(at(ring, around));
  const auto number = [&](const unsigned int ring, const unsigned int around) {
    return ring == 0 ? 0u : (ring == n ? 1u : 2 + (ring - 1) * m + around % m);
  };
  for (unsigned int ring = 0; ring < n; ++ring)
    for (unsigned int around = 0; around < m; ++around)
    {
      const auto a = number(ring, around);
      const auto b = number(ring + 1, around);
      const auto c = number(ring + 1, around + 1);
      const auto d = number(ring, around + 1);
      if (b != c)
        mesh.triangles.push_back({{a, b, c}});
      if (a != d)
        mesh.triangles.push_back({{a, c, d}});
    }
  return mesh;
}

void append(TriangleMesh &mesh, const TriangleMesh &other)
{
  const std::uint32_t first = mesh.vertices.size();
  mesh.vertices.insert(
    mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto &t : other.triangles)
    mesh.triangles.push_back({{first + t[0], first + t[1], first + t[2]}});
}

/// Triangles that share no vertices, as STL files have them.
TriangleMesh to_soup(const TriangleMesh &mesh)
{
  TriangleMesh soup;
  for (const auto &triangle : mesh.triangles)
  {
    const std::uint32_t first = soup.vertices.size();
    for (const std::uint32_t vertex : triangle)
      soup.vertices.push_back(mesh.vertices[vertex]);
    soup.triangles.push_back({{first, first + 1, first + 2}});
  }
  return soup;
}

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

/// A folder for files of one test.
class SurfaceFile : public ::testing::Test
{
protected:
  SurfaceFile()
    : folder_(std::filesystem::temp_directory_path() /
              ("contrecoup_surface_" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(folder_);
  }

  ~SurfaceFile() override
  {
    std::filesystem::remove_all(folder_);
  }

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
  static BodyPointer create(const std::string &file,
                            const std::vector<std::string> &more = {})
  {
    dealii::ParameterHandler prm;
    BodyDescription::declare_parameters(prm);
    std::vector<Assignment> assignments{parse_override("Kind=surface"),
                                        parse_override("Surface/File=" + file)};
    for (const std::string &line : more)
      assignments.push_back(parse_override(line));
    apply_assignments(assignments, prm);
    BodyDescription description;
    description.parse_parameters(prm);
    return description.create();
  }

  static std::string refusal(const std::string &file,
                             const std::vector<std::string> &more = {})
  {
    try
    {
      create(file, more);
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
} // namespace


TEST(TriangulatedSurface, DistanceIsThatOfTheTriangles)
{
  const TriangleMesh mesh = make_sphere(24);
  const TriangulatedSurface surface(mesh);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> place(-1.6, 1.6);
  for (unsigned int i = 0; i < 300; ++i)
  {
    const Point<3> p(place(generator), place(generator), place(generator));
    // The polyhedron lies within 1 - cos(pi / 48) of the sphere.
    EXPECT_NEAR(surface.value(p), p.norm() - 1., 0.005) << p;
    EXPECT_NEAR(surface.gradient(p) * p / p.norm(), 1., 0.01) << p;
    EXPECT_NEAR(surface.winding_number(p), p.norm() < 1. ? 1. : 0., 0.03) << p;
    const Point<3> q =
      p + 0.01 * Point<3>(place(generator), place(generator), place(generator));
    EXPECT_LE(std::abs(surface.value(p) - surface.value(q)),
              p.distance(q) + 1e-12);
  }
}


TEST(TriangulatedSurface, OverlappingPiecesAreOneBody)
{
  TriangleMesh mesh = make_sphere(16);
  append(mesh, make_sphere(16, Point<3>(1., 0., 0.)));
  repair(mesh);
  const TriangulatedSurface surface(mesh);
  EXPECT_NEAR(surface.winding_number({0.5, 0., 0.}), 2., 0.03);
  EXPECT_LT(surface.value({0.5, 0.1, 0.}), 0.);
  EXPECT_LT(surface.value({1.9, 0., 0.}), 0.);
  EXPECT_GT(surface.value({0.5, 0.95, 0.}), 0.);
  const auto pairs = find_self_intersections(mesh);
  ASSERT_FALSE(pairs.empty());
  for (const TrianglePair &pair : pairs)
    EXPECT_NEAR(pair.place[0], 0.5, 0.2);
}


TEST(TriangulatedSurface, CleanSurfacesHaveNoIntersections)
{
  EXPECT_TRUE(find_self_intersections(make_sphere(20)).empty());
}


TEST(TriangleRepair, SoupBecomesOneClosedPiece)
{
  const TriangleMesh sphere = make_sphere(16);
  TriangleMesh mesh = to_soup(sphere);
  const RepairReport report = repair(mesh);
  EXPECT_EQ(report.n_pieces, 1u);
  EXPECT_EQ(mesh.vertices.size(), sphere.vertices.size());
  EXPECT_EQ(report.n_holes + report.n_flipped + report.n_open_edges, 0u);
  EXPECT_TRUE(report.lines().empty());
  EXPECT_NEAR(mesh.volume(), sphere.volume(), 1e-12);
}


TEST(TriangleRepair, FlippedAndMissingTrianglesAreMended)
{
  const TriangleMesh sphere = make_sphere(16);
  TriangleMesh mesh = to_soup(sphere);
  std::mt19937 generator(9);
  unsigned int n_flipped = 0;
  for (auto &triangle : mesh.triangles)
    if (generator() % 4 == 0)
    {
      std::swap(triangle[0], triangle[1]);
      ++n_flipped;
    }
  // Two holes: of one triangle, and of two neighbours; and a sliver.
  mesh.triangles.erase(mesh.triangles.begin() + 200);
  mesh.triangles.erase(mesh.triangles.begin() + 300,
                       mesh.triangles.begin() + 302);
  mesh.triangles.push_back({{0, 0, 1}});
  const RepairReport report = repair(mesh);
  EXPECT_NEAR(report.n_flipped, n_flipped, 3.);
  EXPECT_EQ(report.n_holes, 2u);
  EXPECT_EQ(report.n_degenerate, 1u);
  EXPECT_EQ(report.n_open_edges, 0u);
  EXPECT_NEAR(mesh.volume(), sphere.volume(), 1e-2);
  EXPECT_EQ(report.lines().size(), 3u);
}


TEST(TriangleRepair, InsideOutIsTurnedAndCavitiesStay)
{
  TriangleMesh mesh = make_sphere(12);
  for (auto &triangle : mesh.triangles)
    std::swap(triangle[0], triangle[1]);
  EXPECT_EQ(repair(mesh).n_flipped, mesh.triangles.size());
  EXPECT_GT(mesh.volume(), 0.);

  TriangleMesh hollow = make_sphere(12);
  TriangleMesh cavity = make_sphere(12, Point<3>(), 0.5);
  for (auto &triangle : cavity.triangles)
    std::swap(triangle[0], triangle[1]);
  append(hollow, cavity);
  EXPECT_EQ(repair(hollow).n_flipped, 0u);
  const TriangulatedSurface surface(hollow);
  EXPECT_NEAR(surface.value({0., 0., 0.}), 0.5, 0.02);
  EXPECT_NEAR(surface.value({0., 0., 0.75}), -0.25, 0.02);
}


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

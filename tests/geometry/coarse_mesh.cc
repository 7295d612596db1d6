// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>

#include <deal.II/grid/grid_tools.h>

#include "../set_entries.h"
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace contrecoup;
using dealii::Point;
using dealii::Triangulation;

namespace
{
template <int dim>
CoarseMesh<dim> parse(const std::vector<std::string> &lines)
{
  return described<CoarseMesh<dim>>(lines);
}


/// The message with which a mesh is refused; empty when it is not.
template <int dim>
std::string refusal(const std::vector<std::string> &lines)
{
  try
  {
    Triangulation<dim> tria;
    parse<dim>(lines).create(tria);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}


/// Expects one line that holds all of @p words.
void expect_names(const std::string &message,
                  const std::vector<std::string> &words)
{
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  for (const std::string &word : words)
    EXPECT_NE(message.find(word), std::string::npos)
      << "\"" << word << "\" is not in: " << message;
}


/// A Gmsh file (format 2.2) of the 2-D @p vertices and @p quads, removed
/// again at the end; it claims as many nodes as the number of them followed by
/// the digits @p more_nodes.
class MeshFile
{
public:
  MeshFile(const std::vector<Point<2>> &vertices,
           const std::vector<std::array<unsigned int, 4>> &quads,
           const std::string &more_nodes = "")
    : path_((std::filesystem::temp_directory_path() /
             ("contrecoup_coarse_mesh_" + std::to_string(getpid()) + ".msh"))
              .string())
  {
    std::ofstream out(path_);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
        << vertices.size() << more_nodes << "\n";
    for (unsigned int v = 0; v < vertices.size(); ++v)
      out << v + 1 << " " << vertices[v] << " 0\n";
    out << "$EndNodes\n$Elements\n" << quads.size() << "\n";
    for (unsigned int q = 0; q < quads.size(); ++q)
    {
      out << q + 1 << " 3 2 0 1";
      for (const unsigned int v : quads[q])
        out << " " << v + 1;
      out << "\n";
    }
    out << "$EndElements\n";
  }

  ~MeshFile()
  {
    std::filesystem::remove(path_);
  }

  std::vector<std::string> lines() const
  {
    return {"Domain/Mesh=file", "Domain/Mesh file=" + path_};
  }

private:
  const std::string path_;
};
} // namespace


TEST(CoarseMesh, BoxHasItsLeavesExtentsAndSides)
{
  const auto mesh = parse<3>({"Domain/Lower corner=-1, 0, 2",
                              "Domain/Upper corner=1, 3, 2.5",
                              "Domain/Coarse leaves=4, 3, 1",
                              "Domain/Initial refinement=2"});
  EXPECT_TRUE(mesh.is_axis_aligned());
  EXPECT_EQ(mesh.geometry(), Geometry::plane);
  EXPECT_EQ(mesh.initial_refinement(), 2u);
  EXPECT_EQ(mesh.n_coarse_cells(), 12.);
  EXPECT_EQ(mesh.coarse_cells(0), 4u);
  EXPECT_EQ(mesh.coarse_cells(1), 3u);
  EXPECT_EQ(mesh.coarse_cells(2), 1u);
  EXPECT_EQ(mesh.lower_corner(), Point<3>(-1., 0., 2.));
  EXPECT_EQ(mesh.upper_corner(), Point<3>(1., 3., 2.5));

  Triangulation<3> tria;
  mesh.create(tria);
  EXPECT_EQ(tria.n_active_cells(), 12u);
  EXPECT_NEAR(dealii::GridTools::volume(tria), 3., 1e-13);
  for (const auto &face : tria.active_face_iterators())
  {
    const unsigned int side = face->boundary_id();
    if (!face->at_boundary())
      continue;
    ASSERT_LT(side, 6u);
    const auto &corner = side % 2 ? mesh.upper_corner() : mesh.lower_corner();
    EXPECT_EQ(face->center()[side / 2], corner[side / 2]);
  }
}


TEST(CoarseMesh, PointsFindTheirCoarseCell)
{
  const auto mesh = parse<2>({"Domain/Lower corner=-1, 0",
                              "Domain/Upper corner=1, 3",
                              "Domain/Coarse leaves=4, 3"});
  Triangulation<2> tria;
  mesh.create(tria);
  for (const auto &cell : tria.active_cell_iterators())
  {
    EXPECT_EQ(mesh.coarse_cell_at(cell->center()), cell->index());
    // Shared faces belong to the upper cell.
    EXPECT_EQ(mesh.coarse_cell_at(cell->vertex(0)), cell->index());
  }
  EXPECT_EQ(mesh.coarse_cell_at({1., 3.}), 11u);
}


TEST(CoarseMesh, RadialExponentsOfTheGeometries)
{
  EXPECT_EQ(radial_exponent(Geometry::plane), 0u);
  EXPECT_EQ(radial_exponent(Geometry::cylindrical), 1u);
  EXPECT_EQ(radial_exponent(Geometry::axisymmetric), 1u);
  EXPECT_EQ(radial_exponent(Geometry::spherical), 2u);
  EXPECT_EQ(parse<1>({"Domain/Geometry=spherical"}).geometry(),
            Geometry::spherical);
  EXPECT_EQ(parse<1>({"Domain/Geometry=cylindrical"}).geometry(),
            Geometry::cylindrical);
  EXPECT_EQ(parse<2>({"Domain/Geometry=axisymmetric"}).geometry(),
            Geometry::axisymmetric);
}


TEST(CoarseMesh, PeriodicSidesMeet)
{
  const auto mesh =
    parse<2>({"Domain/Coarse leaves=3, 2", "Domain/Periodic directions=y"});
  EXPECT_FALSE(mesh.is_periodic(0));
  EXPECT_TRUE(mesh.is_periodic(1));
  Triangulation<2> tria;
  mesh.create(tria);
  unsigned int n_pairs = 0;
  for (const auto &cell : tria.active_cell_iterators())
  {
    EXPECT_FALSE(cell->has_periodic_neighbor(0));
    EXPECT_FALSE(cell->has_periodic_neighbor(1));
    if (!cell->has_periodic_neighbor(3))
      continue;
    ++n_pairs;
    const auto other = cell->periodic_neighbor(3);
    EXPECT_EQ(other->center()[0], cell->center()[0]);
    EXPECT_LT(other->center()[1], cell->center()[1]);
  }
  EXPECT_EQ(n_pairs, 3u);
}


TEST(CoarseMesh, BadBoxesAreRefused)
{
  expect_names(refusal<2>({"Domain/Upper corner=1, -2"}),
               {"Domain/Upper corner", "-2", "direction y"});
  expect_names(refusal<1>({"Domain/Lower corner=1"}),
               {"Domain/Upper corner", "direction x"});
  expect_names(refusal<3>({"Domain/Lower corner=0, 0"}),
               {"Domain/Lower corner", "3"});
  expect_names(refusal<3>({"Domain/Coarse leaves=4"}),
               {"Domain/Coarse leaves", "3"});
  expect_names(refusal<2>({"Domain/Periodic directions=z"}),
               {"Domain/Periodic directions", "z", "2"});
  expect_names(refusal<1>({"Domain/Geometry=axisymmetric"}),
               {"Domain/Geometry", "axisymmetric", "1"});
  expect_names(refusal<2>({"Domain/Geometry=spherical"}),
               {"Domain/Geometry", "spherical", "2"});
  expect_names(
    refusal<1>({"Domain/Geometry=spherical", "Domain/Lower corner=-0.5"}),
    {"Domain/Lower corner", "radius"});
  expect_names(refusal<2>({"Domain/Geometry=axisymmetric",
                           "Domain/Periodic directions=x"}),
               {"Domain/Periodic directions", "radius"});
  expect_names(refusal<2>({"Domain/Coarse leaves=0, 1"}),
               {"Domain", "Coarse leaves"});
  expect_names(refusal<2>({"Domain/Initial refinement=-1"}),
               {"Domain", "Initial refinement"});
  expect_names(refusal<2>({"Domain/Lower corner=0, zero"}),
               {"Domain", "Lower corner"});
  expect_names(refusal<2>({"Domain/Mesh=sphere"}), {"Domain", "Mesh"});
  expect_names(
    refusal<2>({"Domain/Mesh=generator", "Domain/Periodic directions=x"}),
    {"Domain/Periodic directions", "generator"});
  expect_names(
    refusal<2>({"Domain/Mesh=generator", "Domain/Geometry=axisymmetric"}),
    {"Domain/Geometry", "generator"});
  expect_names(refusal<1>({"Domain/Mesh=generator"}), {"Domain/Mesh", "box"});
  // Spelled right, each of these scenes is accepted.
  EXPECT_EQ(refusal<2>(
              {"Domain/Periodic directions=y", "Domain/Geometry=axisymmetric"}),
            "");
}


TEST(CoarseMesh, GeneratorsMakeTheirMesh)
{
  Triangulation<3> ball;
  const auto mesh =
    parse<3>({"Domain/Mesh=generator",
              "Domain/Generator=hyper_ball",
              "Domain/Generator arguments=1, 0, 0 : 2 : false"});
  EXPECT_FALSE(mesh.is_axis_aligned());
  EXPECT_EQ(mesh.n_coarse_cells(), 0.);
  mesh.create(ball);
  EXPECT_EQ(ball.n_active_cells(), 7u);
  for (const auto &face : ball.active_face_iterators())
    for (unsigned int v = 0; v < 4; ++v)
      if (face->at_boundary())
      {
        EXPECT_NEAR(face->vertex(v).distance({1., 0., 0.}), 2., 1e-12);
      }

  expect_names(
    refusal<3>({"Domain/Mesh=generator", "Domain/Generator=hyper_bowl"}),
    {"Domain/Generator", "hyper_bowl"});
  expect_names(refusal<3>({"Domain/Mesh=generator",
                           "Domain/Generator=hyper_ball",
                           "Domain/Generator arguments=one : two"}),
               {"Domain/Generator", "one : two"});
}


TEST(CoarseMesh, MeshFilesAreRead)
{
  const MeshFile file(
    {{0., 0.}, {1., 0.}, {2., 0.}, {0., 1.}, {1., 1.5}, {2., 1.}},
    {{{0, 1, 4, 3}}, {{1, 2, 5, 4}}});
  Triangulation<2> tria;
  parse<2>(file.lines()).create(tria);
  EXPECT_EQ(tria.n_active_cells(), 2u);
  EXPECT_NEAR(dealii::GridTools::volume(tria), 2.5, 1e-13);
}


// Without common nodes the side between the cells would be a wall.
TEST(CoarseMesh, CellsOfMeshFilesThatTouchAreJoined)
{
  const auto file = [](const double gap) {
    const double x = 1. + gap;
    return MeshFile({{0., 0.},
                     {1., 0.},
                     {1., 1.},
                     {0., 1.},
                     {x, 0.},
                     {2., 0.},
                     {2., 1.},
                     {x, 1.}},
                    {{{0, 1, 2, 3}}, {{4, 5, 6, 7}}});
  };
  const auto count_inner = [](const MeshFile &written) {
    Triangulation<2> tria;
    parse<2>(written.lines()).create(tria);
    return std::count_if(tria.active_face_iterators().begin(),
                         tria.active_face_iterators().end(),
                         [](const auto &face) { return !face->at_boundary(); });
  };
  EXPECT_EQ(count_inner(file(1e-7)), 1);
  EXPECT_EQ(count_inner(file(0.1)), 0);
}


TEST(CoarseMesh, InvertedCellsAreNamedWithTheirPlace)
{
  // One corner of the second cell is pushed through its opposite side.
  const MeshFile file(
    {{0., 0.}, {1., 0.}, {2., 0.}, {0., 1.}, {1., 1.}, {0.25, -1.}},
    {{{0, 1, 4, 3}}, {{1, 2, 5, 4}}});
  expect_names(refusal<2>(file.lines()),
               {"Domain/Mesh file", "cell 1", "1.0625 0", "inverted"});
}


TEST(CoarseMesh, UnreadableFilesAreRefused)
{
  expect_names(
    refusal<2>({"Domain/Mesh=file", "Domain/Mesh file=/nowhere/a mesh.msh"}),
    {"Domain/Mesh file", "/nowhere/a mesh.msh"});
  const MeshFile empty({}, {});
  expect_names(refusal<2>(empty.lines()), {"Domain/Mesh file"});
  const MeshFile flat({{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}},
                      {{{0, 1, 2, 3}}});
  expect_names(refusal<3>(flat.lines()), {"Domain/Mesh file", "hexahedra"});
  const MeshFile boastful(
    {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}}, {{{0, 1, 2, 3}}}, "00000");
  expect_names(refusal<2>(boastful.lines()),
               {"Domain/Mesh file", "claims 400000 nodes or cells"});
}


// A frustum of a square pyramid around the x axis.
TEST(CoarseMeshCone, HasItsAngleAndVolume)
{
  const auto mesh = parse<3>({"Domain/Mesh=cone",
                              "Domain/Cone angle=60",
                              "Domain/Lower corner=0.5, 0, 0",
                              "Domain/Upper corner=2, 0, 0",
                              "Domain/Coarse leaves=3, 1, 1"});
  EXPECT_FALSE(mesh.is_axis_aligned());
  Triangulation<3> tria;
  mesh.create(tria);
  EXPECT_EQ(tria.n_active_cells(), 3U);
  const double slope = std::tan(30. * dealii::numbers::PI / 180.);
  EXPECT_NEAR(dealii::GridTools::volume(tria),
              4. / 3. * slope * slope * (8. - 0.125),
              1e-12);
  EXPECT_EQ(tria.get_boundary_ids().size(), 6U);

  Triangulation<2> wedge;
  parse<2>({"Domain/Mesh=cone",
            "Domain/Cone angle=60",
            "Domain/Lower corner=0.5, 0",
            "Domain/Upper corner=2, 0",
            "Domain/Coarse leaves=3, 1"})
    .create(wedge);
  EXPECT_NEAR(dealii::GridTools::volume(wedge), slope * (4. - 0.25), 1e-12);
}


TEST(CoarseMeshCone, NeedsAnInnerRadius)
{
  expect_names(refusal<3>({"Domain/Mesh=cone"}),
               {"Domain/Mesh = cone", "above 0"});
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/mesh_description.h>
#include <contrecoup/ale/mesh/region_descriptions.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/body/layered_ball.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_out.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

using namespace contrecoup;
using namespace contrecoup::ale;

namespace
{
using Mesh = dealii::Triangulation<3>;

/// A mesh file that is removed again, and what is made of it.
class FileMeshes : public ::testing::Test
{
protected:
  FileMeshes()
    : path_(std::filesystem::temp_directory_path() /
            ("contrecoup_file_mesh_" + std::to_string(getpid()) + ".msh"))
  {
    MeshDescription::declare_parameters(prm_);
    RegionDescriptions::declare_parameters(prm_);
    set({"Mesh"}, "Kind", "file");
    set({"Mesh"}, "File", path_);
  }

  ~FileMeshes() override
  {
    std::filesystem::remove(path_);
  }

  void write(const Mesh &mesh) const
  {
    std::ofstream stream(path_);
    stream.precision(16);
    dealii::GridOut out;
    out.set_flags(dealii::GridOutFlags::Msh(true, false));
    out.write_msh(mesh, stream);
  }

  void write(const std::string &text) const
  {
    std::ofstream(path_) << text;
  }

  void set(const std::vector<std::string> &section,
           const std::string &entry,
           const std::string &value)
  {
    apply_assignments({{section, entry, value, "test"}}, prm_);
  }

  MeshDescription read(Mesh &mesh)
  {
    MeshDescription description;
    description.parse_parameters(prm_);
    description.create(mesh);
    return description;
  }

  /// Message with which the file is refused.
  std::string refusal()
  {
    try
    {
      Mesh mesh;
      read(mesh);
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "nothing";
  }

  std::string path_;
  dealii::ParameterHandler prm_;
};

void expect_part(const std::string &part, const std::string &text)
{
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

/// Three layers, in x and y only the positive halves.
void make_head(Mesh &mesh)
{
  LayeredBall ball;
  ball.semi_axes = {
    {{0.07, 0.08, 0.06}}, {{0.075, 0.085, 0.065}}, {{0.08, 0.09, 0.07}}};
  ball.cells_across = {2, 1, 1};
  ball.cells_along_cube = 4;
  ball.is_halved = {{true, true, false}};
  make_layered_ball(ball, mesh);
}

/// A file of Gmsh of cubes with a corner at these places, in groups 4, 5, ...
std::string cubes(const std::vector<std::array<int, 3>> &places,
                  const std::string &names)
{
  std::map<std::array<int, 3>, std::size_t> number;
  std::string elements;
  const std::array<std::array<int, 3>, 8> corners{{{{0, 0, 0}},
                                                   {{1, 0, 0}},
                                                   {{1, 1, 0}},
                                                   {{0, 1, 0}},
                                                   {{0, 0, 1}},
                                                   {{1, 0, 1}},
                                                   {{1, 1, 1}},
                                                   {{0, 1, 1}}}};
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    elements += std::to_string(i + 1) + " 5 2 " + std::to_string(i + 4) + " 1";
    for (std::array<int, 3> corner : corners)
    {
      for (unsigned int d = 0; d < 3; ++d)
        corner[d] += places[i][d];
      const auto node = number.emplace(corner, number.size() + 1).first;
      elements += " " + std::to_string(node->second);
    }
    elements += "\n";
  }
  std::string nodes;
  for (const auto &[place, node] : number)
    nodes += std::to_string(node) + " " + std::to_string(place[0]) + " " +
             std::to_string(place[1]) + " " + std::to_string(place[2]) + "\n";
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names + "$Nodes\n" +
         std::to_string(number.size()) + "\n" + nodes +
         "$EndNodes\n$Elements\n" + std::to_string(places.size()) + "\n" +
         elements + "$EndElements\n";
}
} // namespace

TEST_F(FileMeshes, AreTheHeadThatWasWritten)
{
  Mesh head, mesh;
  make_head(head);
  // Planes are found by where they are.
  Mesh without_numbers;
  without_numbers.copy_triangulation(head);
  for (const auto &face : without_numbers.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(0);
  write(without_numbers);
  set({"Mesh"}, "Symmetry planes", "y, x");
  const MeshDescription description = read(mesh);
  ASSERT_EQ(mesh.n_active_cells(), head.n_active_cells());
  auto expected = head.begin_active();
  for (const auto &cell : mesh.active_cell_iterators())
  {
    EXPECT_LT(cell->center().distance(expected->center()), 1e-15);
    EXPECT_EQ(cell->material_id(), expected->material_id());
    ++expected;
  }
  std::map<unsigned int, double> areas;
  for (const auto &face : head.active_face_iterators())
    if (face->at_boundary())
      areas[face->boundary_id()] += face->measure();
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
      areas[face->boundary_id()] -= face->measure();
  ASSERT_EQ(areas.size(), 3U);
  for (const auto &[id, area] : areas)
    EXPECT_NEAR(area, 0., 1e-15) << id;
  EXPECT_EQ(description.n_cells(), head.n_active_cells());
  EXPECT_EQ(description.computed_fraction(), 0.25);
  EXPECT_EQ(description.file()->n_pieces(), 1U);
  EXPECT_EQ(description.walls().count(1), 1U);
  EXPECT_EQ(description.walls().count(0), 0U);
}

TEST_F(FileMeshes, HaveNamesOfTissuesAndOfTheFile)
{
  Mesh mesh;
  write(cubes({{{0, 0, 0}}, {{1, 0, 0}}}, ""));
  const MeshLayers tissues = read(mesh).layers();
  ASSERT_EQ(tissues.size(), 2U);
  EXPECT_EQ(tissues[0].label(), "brain (4)");
  EXPECT_TRUE(tissues[1].is_called("Spinal cord"));
  EXPECT_TRUE(tissues[1].is_called("5"));
  EXPECT_FALSE(tissues[1].is_called("4"));
  mesh.clear();
  write(cubes({{{0, 0, 0}}, {{1, 0, 0}}},
              "$PhysicalNames\n3\n2 4 \"a side\"\n3 4 \"my brain\"\n"
              "nonsense\n$EndPhysicalNames\n"));
  const MeshLayers names = read(mesh).layers();
  EXPECT_EQ(names[0].label(), "my brain (4)");
  EXPECT_EQ(names[1].label(), "spinal cord (5)");
}

TEST_F(FileMeshes, GiveRegionsTheirCells)
{
  write(cubes({{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}}, ""));
  set({"Region one"}, "Layer", "6");
  set({"Region two"}, "Layer", "Brain");
  const auto regions = [&](Mesh &mesh) {
    RegionDescriptions descriptions;
    descriptions.parse_parameters(prm_);
    descriptions.set_regions(mesh, read(mesh).layers());
  };
  Mesh mesh;
  try
  {
    regions(mesh);
    FAIL() << "a material without a region";
  }
  catch (const InputError &error)
  {
    expect_part("m of \"spinal cord (5)\" is in none", error.what());
  }
  set({"Region two"}, "Layer", "lung");
  mesh.clear();
  try
  {
    regions(mesh);
    FAIL() << "a region without a material";
  }
  catch (const InputError &error)
  {
    expect_part("the mesh has no \"lung\", but brain (4), spinal cord (5), "
                "cerebrospinal fluid (6)",
                error.what());
  }
  set({"Region two"}, "Layer", "any");
  set({"Region two"}, "Where", "x < 2");
  mesh.clear();
  regions(mesh);
  for (const auto &cell : mesh.active_cell_iterators())
    EXPECT_EQ(cell->material_id(), cell->center()[0] < 2. ? 1 : 0);
}

TEST_F(FileMeshes, HaveNumberedSides)
{
  Mesh box, mesh;
  dealii::GridGenerator::subdivided_hyper_rectangle(
    box, {2, 1, 1}, dealii::Point<3>(), dealii::Point<3>(2., 1., 1.), true);
  write(box);
  const MeshDescription description = read(mesh);
  const std::set<unsigned int> expected{1, 2, 3, 4, 5};
  EXPECT_EQ(description.file()->boundaries(), expected);
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
    {
      const auto x = face->center();
      const unsigned int side = x[0] < 1e-9        ? 0
                                : x[0] > 2. - 1e-9 ? 1
                                : x[1] < 1e-9      ? 2
                                : x[1] > 1. - 1e-9 ? 3
                                : x[2] < 1e-9      ? 4
                                                   : 5;
      EXPECT_EQ(face->boundary_id(),
                side == 0 ? 0 : FileMesh::boundary_id(side));
    }
  set({"Side 3"}, "Velocity", "2");
  mesh.clear();
  const auto walls = read(mesh).walls();
  ASSERT_EQ(walls.count(FileMesh::boundary_id(3)), 1U);
  EXPECT_EQ(walls.at(FileMesh::boundary_id(3))(0.), 2.);
  set({"Side 7"}, "Kind", "free");
  expect_part("Side 7: no face of the surface has this number in the file; "
              "there are 1, 2, 3, 4, 5",
              refusal());
  set({"Side top"}, "Kind", "free");
  expect_part("Side top: a mesh of kind file has no such side", refusal());
}

// Two cubes with nodes of their own; faces of number 9 are between them.
TEST_F(FileMeshes, JoinCellsThatTouchAndKeepNumbersOfSides)
{
  std::string nodes;
  for (int n = 0; n < 16; ++n)
    nodes += std::to_string(n + 1) + " " + std::to_string(n / 8 + n % 2) + " " +
             std::to_string(n / 2 % 2) + " " + std::to_string(n / 4 % 2) + "\n";
  write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n16\n" + nodes +
        "$EndNodes\n$Elements\n5\n1 5 2 4 1 1 2 4 3 5 6 8 7\n"
        "2 5 2 5 1 9 10 12 11 13 14 16 15\n3 3 2 7 1 1 3 7 5\n"
        "4 3 2 9 1 2 4 8 6\n5 3 2 9 1 9 11 15 13\n$EndElements\n");
  Mesh mesh;
  const MeshDescription description = read(mesh);
  EXPECT_EQ(mesh.n_used_vertices(), 12U);
  EXPECT_EQ(description.file()->n_pieces(), 1U);
  EXPECT_EQ(description.file()->boundaries(), std::set<unsigned int>{7});
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
    {
      EXPECT_EQ(face->boundary_id(),
                face->center()[0] < 1e-9 ? FileMesh::boundary_id(7) : 0);
    }
}

TEST_F(FileMeshes, TellPiecesThatTouchAtAnEdge)
{
  Mesh mesh;
  write(cubes({{{0, 0, 0}}, {{1, 1, 0}}, {{2, 1, 0}}}, ""));
  EXPECT_EQ(read(mesh).file()->n_pieces(), 2U);
}

TEST_F(FileMeshes, AreRefusedWhereCellsHangOnANode)
{
  write(cubes({{{0, 0, 0}}, {{1, 0, 0}}, {{2, 1, 1}}}, ""));
  expect_part("a cell touches the others at the node (2, 1, 1) m alone, about "
              "which they would swing",
              refusal());
  write(cubes({{{0, 0, 0}}, {{1, 1, 1}}, {{2, 1, 1}}, {{0, 1, 0}}, {{0, 2, 0}}},
              ""));
  EXPECT_EQ(refusal(), "nothing");
  write(cubes(
    {{{0, 0, 0}}, {{1, 1, 1}}, {{2, 1, 1}}, {{0, -1, 0}}, {{0, -2, 0}}}, ""));
  expect_part("2 cells touch the others at the node (1, 1, 1) m alone",
              refusal());
}

TEST_F(FileMeshes, AreRefusedWhereTheyCannotBeUsed)
{
  Mesh mesh;
  dealii::GridGenerator::hyper_cube(mesh);
  mesh.begin_active()->vertex(7) = dealii::Point<3>(0.68, 0.68, 0.68);
  write(mesh);
  expect_part("cell 0 at (0.46, 0.46, 0.46) m is distorted, with a scaled "
              "Jacobian of 0.0734; Mesh/Smallest scaled Jacobian allows 0.1",
              refusal());
  mesh.begin_active()->vertex(7) = dealii::Point<3>(0.6, 0.6, 0.6);
  write(mesh);
  expect_part(" is inverted, with a scaled Jacobian of -", refusal());

  mesh.clear();
  dealii::GridGenerator::subdivided_hyper_cube(mesh, 3, 0., 3.);
  mesh.begin_active()->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
  write(mesh);
  expect_part("hangs amid a larger cell", refusal());

  write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n"
        "3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n1\n1 4 2 4 1 1 2 3 4\n"
        "$EndElements\n");
  expect_part("cells must be 8-node hexahedra", refusal());
  set({"Mesh"}, "File", "/nowhere/head.msh");
  expect_part("there is no such file", refusal());
  set({"Mesh"}, "File", "");
  expect_part("Mesh/Kind = file needs Mesh/File", refusal());
}

TEST_F(FileMeshes, AreRefusedWithoutTheSidesThatTheirUserNames)
{
  Mesh mesh;
  LayeredBall ball;
  ball.semi_axes = {{{0.07, 0.07, 0.07}}};
  ball.cells_across = {2};
  make_layered_ball(ball, mesh);
  write(mesh);
  set({"Mesh"}, "Symmetry planes", "z");
  expect_part("the side at z = -0.07 m is flat on 0 %", refusal());
  set({"Mesh"}, "Symmetry planes", "w");
  expect_part("\"w\" is none of x, y, z", refusal());
}

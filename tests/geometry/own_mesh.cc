// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/mesh/hex_components.h>
#include <contrecoup/geometry/mesh/mesh_file.h>

#include <deal.II/grid/grid_generator.h>

#include "described_body.h"
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace contrecoup;
using dealii::Point;

namespace
{
// Two cubes of 10 mm next to each other along x, in mm, of the groups 1 and 2.
constexpr unsigned int n_nodes = 12;
constexpr unsigned int cubes[2][8] = {{1, 2, 5, 4, 7, 8, 11, 10},
                                      {2, 3, 6, 5, 8, 9, 12, 11}};

Point<3> node(const unsigned int number)
{
  const unsigned int i = number - 1;
  return Point<3>(10. * (i % 3), 10. * (i / 3 % 2), 10. * (i / 6));
}

/// Nodes with numbers, "1 0 0 0".
std::string nodes(const std::string &separator)
{
  std::ostringstream text;
  for (unsigned int n = 1; n <= n_nodes; ++n)
    text << n << separator << node(n)[0] << separator << node(n)[1] << separator
         << node(n)[2] << "\n";
  return text.str();
}

std::string corners(const unsigned int cube,
                    const std::string &separator,
                    const unsigned int first = 1)
{
  std::string text;
  for (const unsigned int corner : cubes[cube])
    text += separator + std::to_string(corner - 1 + first);
  return text;
}

std::string gmsh_2(const std::string &names, const std::string &type = "5")
{
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names + "$Nodes\n12\n" +
         nodes(" ") + "$EndNodes\n$Elements\n2\n1 " + type + " 2 1 1" +
         corners(0, " ") + "\n2 " + type + " 2 2 1" + corners(1, " ") +
         "\n$EndElements\n";
}

const std::string two_names =
  "$PhysicalNames\n2\n3 1 \"inside\"\n3 2 \"skull bone\"\n$EndPhysicalNames\n";

std::string gmsh_4()
{
  std::ostringstream text;
  text << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 2\n"
          "1 0 0 0 10 10 10 1 1 0\n2 10 0 0 20 10 10 1 2 0\n$EndEntities\n"
          "$Nodes\n1 12 1 12\n3 1 0 12\n";
  for (unsigned int n = 1; n <= n_nodes; ++n)
    text << n << "\n";
  for (unsigned int n = 1; n <= n_nodes; ++n)
    text << node(n) << "\n";
  text << "$EndNodes\n$Elements\n2 2 1 2\n3 1 5 1\n1" << corners(0, " ")
       << "\n3 2 5 1\n2" << corners(1, " ") << "\n$EndElements\n";
  return text.str();
}

std::string abaqus()
{
  return "*Heading\n two cubes\n** a comment\n*Part, name=head\n*Node\n" +
         nodes(", ") + "*Element, type=C3D8R\n1" + corners(0, ", ") +
         "\n2,2,3,6,5,\n8,9,12,11\n*Elset, elset=Inside, generate\n1, 1, 1\n"
         "*Elset, elset=Bone\n2\n*Solid Section, elset=Inside, "
         "material=a\n,\n*Solid Section, elset=Bone, material=b\n,\n*End "
         "Part\n*Material, name=a\n*Density\n1e-9\n";
}

std::string ucd()
{
  return "12 2 0 0 0\n" + nodes(" ") + "1 1 hex" + corners(0, " ") +
         "\n2 2 hex" + corners(1, " ") + "\n";
}

std::string vtk()
{
  std::ostringstream text;
  text << "# vtk DataFile Version 3.0\ntwo cubes\nASCII\nDATASET "
          "UNSTRUCTURED_GRID\nPOINTS 12 double\n";
  for (unsigned int n = 1; n <= n_nodes; ++n)
    text << node(n) << "\n";
  text << "CELLS 2 18\n8" << corners(0, " ", 0) << "\n8" << corners(1, " ", 0)
       << "\nCELL_TYPES 2\n12 12\nCELL_DATA 2\nSCALARS MaterialID "
          "int\nLOOKUP_TABLE default\n1 2\n";
  return text.str();
}

class OwnMesh : public BodyFiles
{
protected:
  std::string write(const std::string &name, const std::string &content) const
  {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }

  BodyPointer create(const std::string &file,
                     const std::vector<std::string> &more) const override
  {
    return described_body({"Kind=mesh", "Mesh/Unit=mm", "Mesh/File=" + file},
                          more);
  }

  static void expect(const std::string &message, const std::string &part)
  {
    EXPECT_NE(message.find(part), std::string::npos)
      << "'" << message << "' lacks '" << part << "'";
  }
};
} // namespace


TEST_F(OwnMesh, OfAnyFormatIsTheBody)
{
  for (const std::string &file : {write("a.msh", gmsh_2("")),
                                  write("b.msh", gmsh_4()),
                                  write("c.inp", abaqus()),
                                  write("d.inp", ucd()),
                                  write("e.vtk", vtk())})
  {
    SCOPED_TRACE(file);
    const BodyPointer body =
      create(file, {"Mesh/Tissues=1: brain; 2: skull = skeleton"});
    ASSERT_EQ(body->parts().size(), 2u);
    EXPECT_EQ(body->parts()[1].name, "skull");
    EXPECT_EQ(body->parts()[1].tissue, Tissue::skeleton);
    EXPECT_EQ(body->part_at({0.004, 0.005, 0.009}), 0);
    EXPECT_EQ(body->part_at({0.012, 0.005, 0.001}), 1);
    EXPECT_EQ(body->part_at({0.021, 0.005, 0.001}), LabelGrid::outside);
    EXPECT_NEAR(body->surface()->value({0.01, 0.005, 0.012}), 0.002, 1e-9);
    EXPECT_NEAR(body->surface()->value({0.01, 0.005, 0.007}), -0.003, 1e-9);
    ASSERT_TRUE(body->own_mesh());
    EXPECT_EQ(body->own_mesh()->cells.size(), 2u);
    EXPECT_EQ(body->own_mesh()->boundary.size(), 10u);
    LabelGrid grid = make_grid(body->surface()->bounding_box(), 0.0025);
    body->fill(grid);
    for (const unsigned char part : {0, 1})
      EXPECT_EQ(std::count(grid.labels.begin(), grid.labels.end(), part), 64);
    const auto pieces = count_components(*body->own_mesh(), {0, 1});
    EXPECT_EQ(pieces[0], 1u);
    EXPECT_EQ(pieces[1], 1u);
    EXPECT_EQ(pieces[LabelGrid::outside], 1u);
  }
}


TEST_F(OwnMesh, IsPlacedWithItsHexahedra)
{
  const BodyPointer body = create(write("a.msh", gmsh_2("")),
                                  {"Mesh/Tissues=1-2: gelatin",
                                   "Scale=2",
                                   "Rotation=0, 0, 90",
                                   "Origin=bottom",
                                   "Shift=1, 0, 0.5"});
  // 40 mm along y now.
  EXPECT_EQ(body->part_at({1., 0.019, 0.501}), 1);
  EXPECT_EQ(body->part_at({1., -0.019, 0.519}), 0);
  EXPECT_NEAR(body->surface()->bounding_box().lower_bound(2), 0.5, 1e-12);
  EXPECT_NEAR(body->surface()->bounding_box().side_length(1), 0.04, 1e-12);
}


TEST_F(OwnMesh, GroupsHaveTissuesByNumberOrName)
{
  const std::string named = write("a.msh", gmsh_2(two_names));
  for (const std::string table : {"inside: brain; skull bone: skeleton",
                                  "1: brain; skull bone: skeleton"})
  {
    const BodyPointer body = create(named, {"Mesh/Tissues=" + table});
    EXPECT_EQ(body->parts()[0].tissue, Tissue::brain) << table;
    EXPECT_EQ(body->parts()[1].tissue, Tissue::skeleton) << table;
  }
  const std::string deck = write("a.inp", abaqus());
  EXPECT_EQ(create(deck, {"Mesh/Tissues=Inside: brain; Bone: skeleton"})
              ->parts()[1]
              .tissue,
            Tissue::skeleton);
  // Groups that are named as tissues need no row.
  std::string names = two_names;
  names.replace(names.find("inside"), 6, "brain");
  names.replace(names.find("skull bone"), 10, "water");
  const BodyPointer body = create(write("b.msh", gmsh_2(names)), {});
  EXPECT_EQ(body->parts()[0].tissue, Tissue::brain);
  EXPECT_EQ(body->parts()[1].tissue, Tissue::water);

  expect(refusal(named, {"Mesh/Tissues=1: brain"}),
         "Body/Mesh/Tissues gives these groups of cells no tissue: 2 \"skull "
         "bone\" (1 cells); name each");
  expect(refusal(named, {"Mesh/Tissues=1-2: brain; scalp: skin"}),
         "Body/Mesh/Tissues = \"scalp: skin\" selects no cell of the mesh: its "
         "groups are 1 \"inside\" (1 cells), 2 \"skull bone\" (1 cells)");
  expect(refusal(named, {"Mesh/Tissues=1-2: brain; skull bone: skeleton"}),
         "Body/Mesh/Tissues, row \"skull bone: skeleton\": a row before it "
         "gives group 2 a tissue");
  expect(refusal(named, {"Mesh/Tissues=1: brian"}), "did you mean \"brain\"");
  expect(refusal(named, {"Mesh/Tissues=brain"}), "must read \"group: tissue\"");
}


TEST_F(OwnMesh, UnusableFilesSayWhatIsAccepted)
{
  const std::vector<std::string> all{"Mesh/Tissues=1-2: brain"};
  std::string binary = gmsh_2("");
  binary.replace(binary.find("2.2 0"), 5, "2.2 1");
  expect(refusal(write("a.msh", binary), all), "it is a binary file");
  expect(refusal(write("b.msh", gmsh_2("", "17")), all),
         "it has 20-node hexahedra, which are of second order; cells must be "
         "8-node hexahedra");
  expect(refusal(write("c.msh", gmsh_2("", "12")), all), "27-node hexahedra");
  std::string block = gmsh_4();
  block.replace(block.find("3 2 5 1"), 7, "3 2 4 1");
  expect(refusal(write("d.msh", block), all), "it has tetrahedra");
  std::string quadratic = vtk();
  quadratic.replace(quadratic.find("12 12"), 5, "12 25");
  expect(refusal(write("e.vtk", quadratic), all), "20-node hexahedra");
  std::string of_second_order = abaqus();
  of_second_order.replace(of_second_order.find("C3D8R"), 5, "C3D20");
  expect(refusal(write("f.inp", of_second_order), all),
         "elements of the type C3D20 are of second order; 8-node bricks (C3D8, "
         "C3D8R) are read");
  std::string incomplete = abaqus();
  incomplete.replace(incomplete.find("\n12, "), 5, "\n13, ");
  expect(refusal(write("g.inp", incomplete), all),
         "element 2 has the node 12, which is missing");
  expect(refusal(write("h.msh", "nothing"), all),
         "deal.II cannot read it as a mesh of hexahedra; accepted are ASCII "
         "files of Gmsh 2 or 4 (.msh)");
  expect(refusal(write("i.msh", gmsh_2("")), {"Mesh/Unit=m", all[0]}),
         "Body/Mesh/Unit = cm would make it 0.2 m");
  expect(refusal("", all), "Body/Mesh/File is empty");
}


// Cubes that are written one by one, each with nodes of its own.
TEST_F(OwnMesh, CoincidentNodesAreMerged)
{
  const auto file = [](const std::vector<double> &places) {
    std::ostringstream text;
    text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
         << 8 * places.size() << "\n";
    unsigned int number = 0;
    for (const double place : places)
      for (const unsigned int corner : cubes[0])
        text << ++number << " " << node(corner) + Point<3>(place, 0., 0.)
             << "\n";
    text << "$EndNodes\n$Elements\n" << places.size() << "\n";
    for (unsigned int cell = 0; cell < places.size(); ++cell)
    {
      text << cell + 1 << " 5 2 " << cell + 1 << " 1";
      for (unsigned int v = 1; v <= 8; ++v)
        text << " " << 8 * cell + v;
      text << "\n";
    }
    text << "$EndElements\n";
    return text.str();
  };
  const std::string tissues = "Mesh/Tissues=1-3: brain";
  const BodyPointer body =
    create(write("a.msh", file({10., 0., 20. + 1e-7})), {tissues});
  EXPECT_EQ(body->own_mesh()->nodes.size(), 16u);
  EXPECT_EQ(body->own_mesh()->boundary.size(), 14u);
  EXPECT_EQ(count_components(*body->own_mesh(), {0, 0, 0})[LabelGrid::outside],
            1u);
  const auto remarks = body->remarks();
  const auto count_ends = [](const std::vector<std::string> &lines,
                             const std::string &end) {
    return std::count_if(lines.begin(), lines.end(), [&](const auto &line) {
      return line.size() > end.size() &&
             line.compare(line.size() - end.size(), end.size(), end) == 0;
    });
  };
  EXPECT_EQ(count_ends(remarks, "a.msh: 8 coincident nodes merged"), 1);
  const std::string pieces = "b.msh: the mesh is in 2 pieces that share no "
                             "face; nothing passes from one to the other";
  EXPECT_EQ(count_ends(remarks, pieces.substr(1)), 0);
  // Apart, they stay so.
  const BodyPointer apart =
    create(write("b.msh", file({0., 10.1})), {"Mesh/Tissues=1-2: brain"});
  EXPECT_EQ(apart->own_mesh()->nodes.size(), 16u);
  EXPECT_EQ(apart->own_mesh()->boundary.size(), 12u);
  EXPECT_EQ(count_ends(apart->remarks(), pieces), 1);
  expect(refusal(write("c.msh", file({0., 10., 0.})), {tissues}),
         "more than two cells have the face with a corner at (");
}


// One large cube next to four small ones.
TEST_F(OwnMesh, HangingNodesAreRefused)
{
  std::ostringstream text;
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << 8 + 8 * 4 << "\n";
  unsigned int number = 0;
  const auto add_nodes = [&](const Point<3> &lower, const double width) {
    for (const auto &[x, y, z] : std::vector<std::array<int, 3>>{{{0, 0, 0}},
                                                                 {{1, 0, 0}},
                                                                 {{1, 1, 0}},
                                                                 {{0, 1, 0}},
                                                                 {{0, 0, 1}},
                                                                 {{1, 0, 1}},
                                                                 {{1, 1, 1}},
                                                                 {{0, 1, 1}}})
      text << ++number << " " << lower + width * Point<3>(x, y, z) << "\n";
  };
  add_nodes(Point<3>(), 20.);
  for (const double y : {0., 10.})
    for (const double z : {0., 10.})
      add_nodes(Point<3>(20., y, z), 10.);
  text << "$EndNodes\n$Elements\n5\n";
  for (unsigned int cell = 0; cell < 5; ++cell)
  {
    text << cell + 1 << " 5 2 1 1";
    for (unsigned int v = 1; v <= 8; ++v)
      text << " " << 8 * cell + v;
    text << "\n";
  }
  text << "$EndElements\n";
  expect(refusal(write("a.msh", text.str()), {"Mesh/Tissues=1: brain"}),
         "hangs amid a larger cell");
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/mesh/mesh_format.h>

#include <map>
#include <set>
#include <sstream>

namespace contrecoup
{
namespace
{
  /// Names of shapes by the number of their type in a format.
  using Shapes = std::map<int, std::string>;

  const Shapes gmsh_shapes{{4, "tetrahedra"},
                           {6, "prisms"},
                           {7, "pyramids"},
                           {8, "3-node lines"},
                           {9, "6-node triangles"},
                           {10, "9-node quadrilaterals"},
                           {11, "10-node tetrahedra"},
                           {12, "27-node hexahedra"},
                           {13, "18-node prisms"},
                           {14, "14-node pyramids"},
                           {16, "8-node quadrilaterals"},
                           {17, "20-node hexahedra"},
                           {18, "15-node prisms"},
                           {19, "13-node pyramids"}};

  const Shapes vtk_shapes{{10, "tetrahedra"},
                          {11, "voxels"},
                          {13, "prisms"},
                          {14, "pyramids"},
                          {21, "3-node lines"},
                          {22, "6-node triangles"},
                          {23, "8-node quadrilaterals"},
                          {24, "10-node tetrahedra"},
                          {25, "20-node hexahedra"},
                          {26, "15-node prisms"},
                          {27, "13-node pyramids"},
                          {28, "9-node quadrilaterals"},
                          {29, "27-node hexahedra"},
                          {42, "polyhedra"}};

  const Shapes unv_shapes{{22, "3-node lines"},
                          {24, "3-node lines"},
                          {42, "6-node triangles"},
                          {45, "8-node quadrilaterals"},
                          {92, "6-node triangles"},
                          {95, "8-node quadrilaterals"},
                          {111, "tetrahedra"},
                          {112, "prisms"},
                          {113, "15-node prisms"},
                          {116, "20-node hexahedra"},
                          {118, "10-node tetrahedra"}};

  /// Numbers of the types of cells of a file.
  using Types = std::set<int>;

  std::string refusal(const Types &types,
                      const Shapes &shapes,
                      const unsigned int dimension)
  {
    // Cells of the highest dimension come last in each table.
    std::string name;
    for (const int type : types)
      if (const auto found = shapes.find(type); found != shapes.end())
        name = found->second;
    if (name.empty())
      return "";
    const std::string wanted =
      dimension == 3 ? "8-node hexahedra" : "4-node quadrilaterals";
    return "it has " + name +
           (name.find("-node") == std::string::npos
              ? ", and cells must be " + wanted
              : ", which are of second order; cells must be " + wanted +
                  " (in Gmsh, Mesh.ElementOrder = 1)");
  }

  const std::string binary =
    "it is a binary file; save it as ASCII (in Gmsh, Mesh.Binary = 0)";

  std::string why_unusable_gmsh(std::istream &stream,
                                const unsigned int dimension)
  {
    std::string line;
    int version = 0, is_binary = 0, type = 0;
    Types types;
    while (std::getline(stream, line) && trim(line) != "$MeshFormat")
      ;
    if (!std::getline(stream, line))
      return "";
    std::istringstream format(line);
    std::string rest;
    format >> version >> rest >> is_binary;
    if (is_binary != 0)
      return binary;
    while (std::getline(stream, line) && trim(line) != "$Elements")
      ;
    // The line after the keyword is the number of elements, or of blocks.
    std::getline(stream, line);
    while (std::getline(stream, line) && line.rfind('$', 0) != 0)
    {
      std::istringstream words(line);
      int first = 0, second = 0;
      long count = 0;
      if (version >= 4 && words >> first >> second >> type >> count)
        for (; count > 0 && std::getline(stream, line); --count)
          ;
      else if (version < 4)
        words >> first >> type;
      types.insert(type);
    }
    return refusal(types, gmsh_shapes, dimension);
  }

  std::string why_unusable_vtk(std::istream &stream,
                               const unsigned int dimension)
  {
    Types types;
    std::size_t number = 0;
    for (std::string line; std::getline(stream, line); ++number)
      if (number == 2 && trim(line) == "BINARY")
        return "it is a binary file; save it as ASCII";
      else if (line.rfind("CELL_TYPES ", 0) == 0)
        for (int type = 0; stream >> type;)
          types.insert(type);
    return refusal(types, vtk_shapes, dimension);
  }

  std::string why_unusable_unv(std::istream &stream,
                               const unsigned int dimension)
  {
    Types types;
    std::string line;
    const std::string begin_of_elements = "2412";
    while (std::getline(stream, line) && trim(line) != begin_of_elements)
      ;
    long number = 0, type = 0, skipped = 0, n_nodes = 0;
    while (std::getline(stream, line) && trim(line) != "-1")
    {
      std::istringstream words(line);
      if (!(words >> number >> type >> skipped >> skipped >> skipped >>
            n_nodes))
        break;
      types.insert(static_cast<int>(type));
      // Beams have a line of their own; eight nodes fill a line.
      const bool is_beam = type == 11 || (type >= 21 && type <= 24);
      for (long n = (is_beam ? 1 : 0) + (n_nodes + 7) / 8; n > 0; --n)
        if (!std::getline(stream, line))
          break;
    }
    return refusal(types, unv_shapes, dimension);
  }
} // namespace


const std::string &accepted_mesh_formats()
{
  static const std::string text =
    "ASCII files of Gmsh 2 or 4 (.msh), legacy VTK (.vtk), I-deas (.unv), "
    "Abaqus or UCD (.inp)";
  return text;
}

std::string why_unusable_mesh(std::istream &stream,
                              const std::string &ending,
                              const unsigned int dimension)
{
  std::string why;
  if (ending == "msh")
    why = why_unusable_gmsh(stream, dimension);
  else if (ending == "vtk")
    why = why_unusable_vtk(stream, dimension);
  else if (ending == "unv")
    why = why_unusable_unv(stream, dimension);
  stream.clear();
  stream.seekg(0);
  return why;
}
} // namespace contrecoup

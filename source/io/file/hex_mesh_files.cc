// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/image/label_grid.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/hex_mesh_files.h>
#include <contrecoup/io/file/vtk_file.h>

namespace contrecoup
{
namespace io
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;

    std::string count_attributes(const std::size_t n_points,
                                 const std::size_t n_cells)
    {
      return "NumberOfPoints=\"" + std::to_string(n_points) +
             "\" NumberOfCells=\"" + std::to_string(n_cells) + "\"";
    }

    void add_points(VtkFile &file, const std::vector<Point<3>> &points)
    {
      std::vector<double> coordinates;
      coordinates.reserve(3 * points.size());
      for (const Point<3> &point : points)
        for (unsigned int d = 0; d < 3; ++d)
          coordinates.push_back(point[d]);
      file.add("Points", "points", coordinates, 3, "m");
    }

    /// Adds the names of what the arrays "part" and "tissue" hold.
    void add_names(VtkFile &file, const HexMesh &mesh)
    {
      std::vector<std::string> parts;
      for (const BodyPart &part : mesh.parts)
        parts.push_back(part.name);
      file.add_names("part", parts);
      file.add_names("tissue", tissue_names());
    }

    /// Adds cells with @p width corners each.
    void add_cells(VtkFile &file,
                   const std::vector<std::uint32_t> &connectivity,
                   const unsigned int width,
                   const unsigned char type)
    {
      file.add("Cells", "connectivity", connectivity);
      const std::size_t n_cells = connectivity.size() / width;
      std::vector<std::int64_t> offsets(n_cells);
      for (std::size_t i = 0; i < n_cells; ++i)
        offsets[i] = (i + 1) * width;
      file.add("Cells", "offsets", offsets);
      file.add("Cells", "types", std::vector<unsigned char>(n_cells, type));
    }

    unsigned char tissue_of(const HexMesh &mesh, const unsigned char part)
    {
      return static_cast<unsigned char>(mesh.parts[part].tissue);
    }
  } // namespace


  void write_vtu(const HexMesh &mesh, const std::string &name)
  {
    VtkFile file("UnstructuredGrid",
                 "",
                 count_attributes(mesh.nodes.size(), mesh.cells.size()));
    add_names(file, mesh);
    add_points(file, mesh.nodes);
    std::vector<std::uint32_t> connectivity;
    connectivity.reserve(8 * mesh.cells.size());
    for (const HexMesh::Cell &cell : mesh.cells)
      connectivity.insert(connectivity.end(), cell.begin(), cell.end());
    add_cells(file, connectivity, 8, vtk_hexahedron);
    file.add("CellData", "part", mesh.part);
    std::vector<unsigned char> tissue;
    for (const unsigned char part : mesh.part)
      tissue.push_back(tissue_of(mesh, part));
    file.add("CellData", "tissue", tissue);
    file.write(name);
  }


  void write_msh(const HexMesh &mesh, const std::string &name)
  {
    write_file(name, [&](std::ostream &out) {
      out.precision(12);
      out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
          << tissue_names().size() - 1 << "\n";
      // Gmsh has no group 0, and no element has the tissue "none".
      for (std::size_t i = 1; i < tissue_names().size(); ++i)
        out << "3 " << i << " \"" << tissue_names()[i] << "\"\n";
      out << "$EndPhysicalNames\n$Nodes\n" << mesh.nodes.size() << "\n";
      for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
        out << i + 1 << " " << mesh.nodes[i] << "\n";
      out << "$EndNodes\n$Elements\n" << mesh.cells.size() << "\n";
      constexpr int hexahedron = 5;
      for (std::size_t i = 0; i < mesh.cells.size(); ++i)
      {
        const unsigned char part = mesh.part[i];
        out << i + 1 << " " << hexahedron << " 2 " << int(tissue_of(mesh, part))
            << " " << part + 1;
        for (const std::uint32_t node : mesh.cells[i])
          out << " " << node + 1;
        out << "\n";
      }
      out << "$EndElements\n";
    });
  }


  void write_surface_vtu(const HexMesh &mesh,
                         const Shape &surface,
                         const std::string &name)
  {
    // Renumber the nodes of the surface in the order of use.
    std::vector<std::uint32_t> number(mesh.nodes.size(), -1);
    std::vector<Point<3>> nodes;
    std::vector<std::uint32_t> connectivity;
    std::vector<unsigned char> part;
    std::vector<unsigned char> tissue;
    std::vector<float> normals;
    for (const HexMesh::Facet &facet : mesh.boundary)
    {
      for (const std::uint32_t node : facet.nodes)
      {
        if (number[node] == static_cast<std::uint32_t>(-1))
        {
          number[node] = nodes.size();
          nodes.push_back(mesh.nodes[node]);
        }
        connectivity.push_back(number[node]);
      }
      part.push_back(mesh.part[facet.cell]);
      tissue.push_back(tissue_of(mesh, part.back()));
      const Tensor<1, 3> normal = surface.normal(mesh.center(facet));
      for (unsigned int d = 0; d < 3; ++d)
        normals.push_back(normal[d]);
    }
    VtkFile file("UnstructuredGrid",
                 "",
                 count_attributes(nodes.size(), mesh.boundary.size()));
    add_names(file, mesh);
    add_points(file, nodes);
    add_cells(file, connectivity, 4, vtk_quadrilateral);
    file.add("CellData", "part", part);
    file.add("CellData", "tissue", tissue);
    file.add("CellData", "normal", normals, 3, "-");
    file.write(name);
  }


  void write_surface_stl(const HexMesh &mesh, const std::string &name)
  {
    write_file(name, [&](std::ostream &out) {
      const auto put_vector = [&](const Tensor<1, 3> &vector) {
        const std::array<float, 3> values{{static_cast<float>(vector[0]),
                                           static_cast<float>(vector[1]),
                                           static_cast<float>(vector[2])}};
        out.write(reinterpret_cast<const char *>(values.data()), 12);
      };
      std::string header = "surface of a Contrecoup body, lengths in m";
      header.resize(80, ' ');
      out << header;
      const std::uint32_t count = 2 * mesh.boundary.size();
      out.write(reinterpret_cast<const char *>(&count), 4);
      for (const HexMesh::Facet &facet : mesh.boundary)
        for (const auto &[second, third] :
             {std::pair<int, int>{1, 2}, std::pair<int, int>{2, 3}})
        {
          const Point<3> &a = mesh.nodes[facet.nodes[0]];
          const Point<3> &b = mesh.nodes[facet.nodes[second]];
          const Point<3> &c = mesh.nodes[facet.nodes[third]];
          const Tensor<1, 3> area = cross_product_3d(b - a, c - a);
          put_vector(area.norm() > 0. ? area / area.norm() : area);
          for (const Point<3> &corner : {a, b, c})
            put_vector(corner);
          const std::uint16_t unused = 0;
          out.write(reinterpret_cast<const char *>(&unused), 2);
        }
    });
  }


  void write_hanging_nodes(const HexMesh &mesh, const std::string &name)
  {
    write_file(name, [&](std::ostream &out) {
      out << "node,n_masters,masters and weights\n";
      for (const HexMesh::HangingNode &hanging : mesh.hanging_nodes)
      {
        out << hanging.node << "," << hanging.masters.size();
        for (const std::uint32_t master : hanging.masters)
          out << "," << master;
        for (const double weight : hanging.weights)
          out << "," << weight;
        out << "\n";
      }
    });
  }


  void write_distance(const Shape &surface,
                      const double spacing,
                      const double margin,
                      const std::string &name)
  {
    dealii::BoundingBox<3> box = surface.bounding_box();
    box.extend(margin);
    const LabelGrid grid = make_grid(box, spacing, 5e8);
    std::vector<float> values;
    values.reserve(grid.labels.size());
    for (unsigned int k = 0; k < grid.size[2]; ++k)
      for (unsigned int j = 0; j < grid.size[1]; ++j)
        for (unsigned int i = 0; i < grid.size[0]; ++i)
          values.push_back(
            static_cast<float>(surface.value(grid.center(i, j, k))));
    const Point<3> first = grid.center(0, 0, 0);
    std::string extent;
    std::string origin;
    std::string spacings;
    for (unsigned int d = 0; d < 3; ++d)
    {
      extent += "0 " + std::to_string(grid.size[d] - 1) + " ";
      origin += exact(first[d]) + " ";
      spacings += exact(spacing) + " ";
    }
    VtkFile file("ImageData",
                 "WholeExtent=\"" + extent + "\" Origin=\"" + origin +
                   "\" Spacing=\"" + spacings + "\"",
                 "Extent=\"" + extent + "\"");
    file.add("PointData", "signed_distance", values, 1, "m");
    file.write(name);
  }
} // namespace io
} // namespace contrecoup

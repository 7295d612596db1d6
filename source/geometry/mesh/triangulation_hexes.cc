// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/mesh/place_search.h>
#include <contrecoup/geometry/mesh/triangulation_hexes.h>

#include <deal.II/grid/grid_tools.h>

namespace contrecoup
{
namespace
{
  using Mesh = dealii::Triangulation<3>;

  /// Masters of hanging vertices in the middle of edges and faces that are
  /// refined on one side only, by deal.II vertex.
  std::map<unsigned int, std::vector<unsigned int>>
  hanging_vertices(const Mesh &mesh)
  {
    std::map<unsigned int, std::vector<unsigned int>> masters;
    for (const auto &cell : mesh.active_cell_iterators())
    {
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->has_children())
        {
          auto &list = masters[cell->face(f)->child(0)->vertex_index(3)];
          list.clear();
          for (unsigned int v = 0; v < 4; ++v)
            list.push_back(cell->face(f)->vertex_index(v));
        }
      for (const unsigned int l : cell->line_indices())
        if (cell->line(l)->has_children())
          masters[cell->line(l)->child(0)->vertex_index(1)] = {
            cell->line(l)->vertex_index(0), cell->line(l)->vertex_index(1)};
    }
    return masters;
  }

  /// Weights of non-hanging nodes that replace hanging masters.
  std::map<std::uint32_t, double>
  weights_of(const std::map<unsigned int, std::vector<unsigned int>> &masters,
             const unsigned int vertex,
             const std::vector<std::uint32_t> &node)
  {
    const auto found = masters.find(vertex);
    if (found == masters.end())
      return {{node[vertex], 1.}};
    std::map<std::uint32_t, double> weights;
    for (const unsigned int master : found->second)
      for (const auto &[one, weight] : weights_of(masters, master, node))
        weights[one] += weight / found->second.size();
    return weights;
  }

  void add_cells(const Mesh &mesh,
                 const std::size_t n_parts,
                 std::vector<std::uint32_t> &node,
                 HexMesh &result)
  {
    for (const auto &cell : mesh.active_cell_iterators())
    {
      if (cell->material_id() >= n_parts)
        throw InputError("the mesh has a cell of material " +
                         std::to_string(cell->material_id()) +
                         ", known are 0 to " + std::to_string(n_parts - 1));
      HexMesh::Cell corners;
      for (unsigned int c = 0; c < 8; ++c)
      {
        const unsigned int vertex = cell->vertex_index(vertex_of_corner[c]);
        if (node[vertex] == no_index)
        {
          node[vertex] = result.nodes.size();
          result.nodes.push_back(mesh.get_vertices()[vertex]);
        }
        corners[c] = node[vertex];
      }
      const auto number = static_cast<std::uint32_t>(result.cells.size());
      result.cells.push_back(corners);
      result.part.push_back(static_cast<unsigned char>(cell->material_id()));
      for (unsigned int f = 0; f < 6; ++f)
        if (cell->at_boundary(f))
        {
          HexMesh::Facet facet;
          facet.cell = number;
          for (unsigned int v = 0; v < 4; ++v)
            facet.nodes[v] = corners[hex_face_corners[f][v]];
          result.boundary.push_back(facet);
        }
    }
  }

  /// Vertices of boundary faces.
  std::vector<dealii::Point<3>> boundary_vertices(const Mesh &mesh)
  {
    std::vector<bool> is_used(mesh.n_vertices(), false);
    std::vector<dealii::Point<3>> result;
    for (const auto &face : mesh.active_face_iterators())
      for (unsigned int v = 0; face->at_boundary() && v < 4; ++v)
        if (!is_used[face->vertex_index(v)])
        {
          is_used[face->vertex_index(v)] = true;
          result.push_back(face->vertex(v));
        }
    return result;
  }
} // namespace


HexMesh to_hex_mesh(const Mesh &triangulation,
                    const std::vector<BodyPart> &parts)
{
  HexMesh result;
  result.parts = parts;
  std::vector<std::uint32_t> node(triangulation.n_vertices(), no_index);
  add_cells(triangulation, parts.size(), node, result);
  const auto masters = hanging_vertices(triangulation);
  for (const auto &[vertex, list] : masters)
  {
    HexMesh::HangingNode one;
    one.node = node[vertex];
    for (const auto &[master, weight] : weights_of(masters, vertex, node))
    {
      one.masters.push_back(master);
      one.weights.push_back(weight);
    }
    result.hanging_nodes.push_back(std::move(one));
  }
  return result;
}


void distort(Mesh &mesh, const double part)
{
  dealii::GridTools::distort_random(part, mesh, true);
}


std::optional<dealii::Point<3>> find_hanging_vertex(const Mesh &mesh)
{
  const auto vertices = boundary_vertices(mesh);
  const PlaceSearch search(vertices);
  const auto is_vertex = [&](const dealii::Point<3> &middle,
                             const double size) {
    const auto nearest = search.nearest(middle, 1);
    return !nearest.empty() &&
           vertices[nearest[0]].distance(middle) < 1e-6 * size;
  };
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
    {
      if (is_vertex(face->center(), face->diameter()))
        return face->center();
      for (unsigned int l = 0; l < 4; ++l)
        if (is_vertex(face->line(l)->center(), face->line(l)->diameter()))
          return face->line(l)->center();
    }
  return {};
}
} // namespace contrecoup

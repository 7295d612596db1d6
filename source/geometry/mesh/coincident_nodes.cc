// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/mesh/coincident_nodes.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace contrecoup
{
namespace
{
  using Mesh = dealii::Triangulation<3>;
  using Cells = std::vector<dealii::CellData<3>>;

  std::vector<unsigned int> boundary_nodes(const Mesh &mesh)
  {
    std::set<unsigned int> nodes;
    for (const auto &face : mesh.active_face_iterators())
      for (unsigned int v = 0; face->at_boundary() && v < 4; ++v)
        nodes.insert(face->vertex_index(v));
    return {nodes.begin(), nodes.end()};
  }

  /// deal.II fails on such meshes, in release mode without a message.
  void require_two_cells_at_faces(const std::vector<dealii::Point<3>> &nodes,
                                  const Cells &cells,
                                  const std::string &where)
  {
    std::map<std::array<unsigned int, 4>, unsigned int> n_cells;
    for (const auto &cell : cells)
      for (unsigned int f = 0; f < 6; ++f)
      {
        std::array<unsigned int, 4> face;
        for (unsigned int v = 0; v < 4; ++v)
          face[v] =
            cell.vertices[dealii::GeometryInfo<3>::face_to_cell_vertices(f, v)];
        std::sort(face.begin(), face.end());
        if (++n_cells[face] > 2)
          throw InputError(where +
                           ": more than two cells have the face with "
                           "a corner at (" +
                           coordinates(nodes[face[0]]) +
                           "); cells must not overlap");
      }
  }
} // namespace


std::string merge_coincident_nodes(Mesh &mesh, const std::string &where)
{
  std::vector<dealii::Point<3>> nodes = mesh.get_vertices();
  Cells cells;
  double shortest = std::numeric_limits<double>::max();
  for (const auto &cell : mesh.active_cell_iterators())
  {
    cells.emplace_back();
    for (const unsigned int v : cell->vertex_indices())
      cells.back().vertices[v] = cell->vertex_index(v);
    cells.back().material_id = cell->material_id();
    shortest = std::min(shortest, cell->minimum_vertex_distance());
  }
  std::vector<unsigned int> considered = boundary_nodes(mesh);
  dealii::SubCellData no_numbers;
  dealii::GridTools::delete_duplicated_vertices(
    nodes, cells, no_numbers, considered, 1e-4 * shortest);
  const std::size_t n_merged = mesh.n_used_vertices() - nodes.size();
  if (n_merged == 0)
    return "";
  require_two_cells_at_faces(nodes, cells, where);
  dealii::GridTools::consistently_order_cells(cells);
  mesh.clear();
  mesh.create_triangulation(nodes, cells, no_numbers);
  return std::to_string(n_merged) +
         (n_merged == 1 ? " coincident node" : " coincident nodes") + " merged";
}
} // namespace contrecoup

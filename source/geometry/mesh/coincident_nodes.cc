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
  template <int dim>
  using Cells = std::vector<dealii::CellData<dim>>;

  template <int dim>
  using Face = std::array<unsigned int, (1 << (dim - 1))>; ///< sorted nodes

  template <int dim>
  std::vector<unsigned int>
  boundary_nodes(const dealii::Triangulation<dim> &mesh)
  {
    std::set<unsigned int> nodes;
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        for (const unsigned int v : face->vertex_indices())
          nodes.insert(face->vertex_index(v));
    return {nodes.begin(), nodes.end()};
  }

  template <int dim>
  Cells<dim> cells_of(const dealii::Triangulation<dim> &mesh)
  {
    Cells<dim> cells;
    for (const auto &cell : mesh.active_cell_iterators())
    {
      cells.emplace_back();
      for (const unsigned int v : cell->vertex_indices())
        cells.back().vertices[v] = cell->vertex_index(v);
      cells.back().material_id = cell->material_id();
    }
    return cells;
  }

  auto &faces_of(dealii::SubCellData &numbers,
                 const std::integral_constant<int, 2> &)
  {
    return numbers.boundary_lines;
  }
  auto &faces_of(dealii::SubCellData &numbers,
                 const std::integral_constant<int, 3> &)
  {
    return numbers.boundary_quads;
  }

  /// Faces of the surface with a number.
  template <int dim>
  dealii::SubCellData numbered_faces(const dealii::Triangulation<dim> &mesh)
  {
    dealii::SubCellData numbers;
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary() && face->boundary_id() != 0)
      {
        dealii::CellData<dim - 1> one;
        for (const unsigned int v : face->vertex_indices())
          one.vertices[v] = face->vertex_index(v);
        one.boundary_id = face->boundary_id();
        faces_of(numbers, std::integral_constant<int, dim>()).push_back(one);
      }
    return numbers;
  }

  /// Number of cells of each face. deal.II fails on meshes with a face of
  /// more than two, in release mode without a message.
  template <int dim>
  std::map<Face<dim>, unsigned int>
  count_cells(const std::vector<dealii::Point<dim>> &nodes,
              const Cells<dim> &cells,
              const std::string &where)
  {
    using Info = dealii::GeometryInfo<dim>;
    std::map<Face<dim>, unsigned int> n_cells;
    for (const auto &cell : cells)
      for (unsigned int f = 0; f < Info::faces_per_cell; ++f)
      {
        Face<dim> face;
        for (unsigned int v = 0; v < face.size(); ++v)
          face[v] = cell.vertices[Info::face_to_cell_vertices(f, v)];
        std::sort(face.begin(), face.end());
        if (++n_cells[face] > 2)
          throw InputError(where +
                           ": more than two cells have the face with "
                           "a corner at (" +
                           coordinates(nodes[face[0]]) +
                           "); cells must not overlap");
      }
    return n_cells;
  }

  template <int dim>
  double shortest_edge(const dealii::Triangulation<dim> &mesh)
  {
    double shortest = std::numeric_limits<double>::max();
    for (const auto &cell : mesh.active_cell_iterators())
      shortest = std::min(shortest, cell->minimum_vertex_distance());
    return shortest;
  }
} // namespace


template <int dim>
std::string merge_coincident_nodes(dealii::Triangulation<dim> &mesh,
                                   const std::string &where)
{
  const double shortest = shortest_edge(mesh);
  if (!(shortest > 0.))
    return "";
  std::vector<dealii::Point<dim>> nodes = mesh.get_vertices();
  Cells<dim> cells = cells_of(mesh);
  dealii::SubCellData numbers = numbered_faces(mesh);
  std::vector<unsigned int> considered = boundary_nodes(mesh);
  dealii::GridTools::delete_duplicated_vertices(
    nodes, cells, numbers, considered, 1e-4 * shortest);
  const std::size_t n_merged = mesh.n_used_vertices() - nodes.size();
  if (n_merged == 0)
    return "";
  const auto n_cells = count_cells<dim>(nodes, cells, where);
  auto &faces = faces_of(numbers, std::integral_constant<int, dim>());
  faces.erase(std::remove_if(
                faces.begin(),
                faces.end(),
                [&](const auto &one) {
                  Face<dim> face;
                  std::copy_n(one.vertices.begin(), face.size(), face.begin());
                  std::sort(face.begin(), face.end());
                  return n_cells.at(face) > 1;
                }),
              faces.end());
  dealii::GridTools::consistently_order_cells(cells);
  mesh.clear();
  mesh.create_triangulation(nodes, cells, numbers);
  return where + ": " + std::to_string(n_merged) +
         (n_merged == 1 ? " coincident node" : " coincident nodes") + " merged";
}


template <>
std::string merge_coincident_nodes(dealii::Triangulation<1> &,
                                   const std::string &)
{
  return "";
}
template std::string merge_coincident_nodes(dealii::Triangulation<2> &,
                                            const std::string &);
template std::string merge_coincident_nodes(dealii::Triangulation<3> &,
                                            const std::string &);
} // namespace contrecoup

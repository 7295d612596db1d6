// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/file_mesh.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/tissues.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/mesh/hex_quality.h>
#include <contrecoup/geometry/mesh/mesh_file.h>
#include <contrecoup/geometry/mesh/mesh_format.h>
#include <contrecoup/geometry/mesh/mesh_pieces.h>
#include <contrecoup/geometry/mesh/triangulation_hexes.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
namespace
{
  using dealii::Point;
  using Mesh = dealii::Triangulation<3>;


  constexpr unsigned int no_piece = -1;

  /// Calls @p meet for each two sets of cells that share one of the numbered
  /// parts (vertices or edges).
  template <typename Part, typename Meet>
  void find_contacts(const Mesh &mesh,
                     const std::vector<unsigned int> &piece,
                     const std::size_t n_parts,
                     const Part &parts_of,
                     const Meet &meet)
  {
    std::vector<unsigned int> first(n_parts, no_piece);
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int part : parts_of(cell))
      {
        const unsigned int own = piece[cell->index()];
        if (first[part] == no_piece)
          first[part] = own;
        else if (first[part] != own)
          meet(own, first[part], part);
      }
  }
} // namespace


void FileMesh::declare_parameters(ParameterHandler &prm)
{
  declare_file(
    prm,
    "File",
    "",
    "Mesh of 8-node hexahedra with lengths in m, as `anatomy` writes "
    "mesh.msh: " +
      accepted_mesh_formats() +
      ". Regions refer to its materials; numbers of surface faces "
      "are names of sides.");
  declare_double(prm,
                 "Smallest scaled Jacobian",
                 "0.1",
                 1e-6,
                 0.9,
                 "-",
                 "Files with a smaller scaled Jacobian are refused; a box "
                 "has 1, a folded cell 0. Smoothed meshes of `anatomy` have "
                 "at least 0.2.");
}


void FileMesh::parse_parameters(ParameterHandler &prm)
{
  file_ = prm.get("File");
  if (file_.empty())
    throw InputError("Mesh/Kind = file needs Mesh/File");
  least_jacobian_ = read_double(prm, "Smallest scaled Jacobian");
  planes_ = read_symmetry_planes(prm);
}


void FileMesh::refuse(const std::string &reason) const
{
  throw InputError("Mesh/File = " + file_ + ": " + reason);
}


const FileMesh::MeshStatistics &FileMesh::statistics() const
{
  if (!statistics_)
  {
    Mesh mesh;
    create(mesh);
  }
  return *statistics_;
}


void FileMesh::create(Mesh &mesh) const
{
  for (const std::string &line : read_mesh_file(file_, "Mesh/File", mesh))
    log_line(line);
  auto found = std::make_shared<MeshStatistics>();
  measure_cells(mesh, *found);
  refuse_hanging_nodes(mesh);
  found->n_pieces = refuse_joints(mesh);
  found->layers = number_layers(mesh);
  found->boundaries = number_boundaries(mesh);
  for (unsigned int d = 0; d < 3; ++d)
    if (planes_[d])
      cut_by_plane(mesh, d);
  statistics_ = found;
}


void FileMesh::measure_cells(const Mesh &mesh, MeshStatistics &found) const
{
  found.n_cells = mesh.n_active_cells();
  found.cell_size = std::numeric_limits<double>::max();
  std::size_t n_refused = 0;
  std::string worst;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    HexCorners corners;
    for (unsigned int c = 0; c < 8; ++c)
      corners[c] = cell->vertex(vertex_of_corner[c]);
    const double quality = scaled_jacobian(corners);
    found.cell_size =
      std::min(found.cell_size, cell->minimum_vertex_distance());
    n_refused += quality >= least_jacobian_ ? 0 : 1;
    if (quality < found.scaled_jacobian)
    {
      found.scaled_jacobian = quality;
      worst = std::to_string(cell->active_cell_index()) + " at (" +
              coordinates(cell->center()) + ") m";
    }
  }
  if (n_refused > 0)
    refuse("cell " + worst +
           (found.scaled_jacobian > 0. ? " is distorted" : " is inverted") +
           ", with a scaled Jacobian of " + brief(found.scaled_jacobian) +
           (n_refused > 1
              ? ", and " + std::to_string(n_refused - 1) + " more are"
              : "") +
           "; Mesh/Smallest scaled Jacobian allows " + brief(least_jacobian_));
}


void FileMesh::refuse_hanging_nodes(const Mesh &mesh) const
{
  if (const auto place = find_hanging_vertex(mesh))
    refuse("the node at (" + coordinates(*place) + ") m" +
           " hangs amid a larger cell, as after `anatomy` with "
           "Mesh/Coarsening levels above 0; cells must share whole faces");
}


unsigned int FileMesh::refuse_joints(const Mesh &mesh) const
{
  const std::vector<unsigned int> piece = find_pieces(mesh);
  std::vector<std::size_t> n_cells(
    1 + *std::max_element(piece.begin(), piece.end()), 0);
  for (const unsigned int number : piece)
    ++n_cells[number];
  std::vector<bool> has_edge(n_cells.size(), false);
  find_contacts(
    mesh,
    piece,
    mesh.n_raw_lines(),
    [](const auto &cell) {
      std::array<unsigned int, 12> lines;
      for (const unsigned int l : cell->line_indices())
        lines[l] = cell->line_index(l);
      return lines;
    },
    [&](const unsigned int a, const unsigned int b, unsigned int) {
      has_edge[a] = has_edge[b] = true;
    });
  find_contacts(
    mesh,
    piece,
    mesh.n_vertices(),
    [](const auto &cell) {
      std::array<unsigned int, 8> nodes;
      for (unsigned int v = 0; v < 8; ++v)
        nodes[v] = cell->vertex_index(v);
      return nodes;
    },
    [&](const unsigned int a, const unsigned int b, const unsigned int node) {
      const unsigned int smaller = n_cells[a] <= n_cells[b] ? a : b;
      if (has_edge[smaller])
        return;
      const std::size_t n = n_cells[smaller];
      refuse((n == 1 ? "a cell touches" : std::to_string(n) + " cells touch") +
             " the others at the node (" +
             coordinates(mesh.get_vertices()[node]) + ") m" +
             " alone, about which they would swing; leave them out, or join "
             "them by faces");
    });
  return static_cast<unsigned int>(n_cells.size());
}


MeshLayers FileMesh::number_layers(Mesh &mesh) const
{
  const auto names = read_group_names(file_, 3);
  std::map<unsigned int, unsigned int> numbers;
  for (const auto &cell : mesh.active_cell_iterators())
    numbers[cell->material_id()] = 0;
  MeshLayers layers;
  for (auto &[material, number] : numbers)
  {
    number = static_cast<unsigned int>(layers.size());
    MeshLayer layer{std::to_string(material), std::to_string(material)};
    if (const auto name = names.find(material); name != names.end())
      layer.name = name->second;
    else if (material > 0 && material < tissue_names().size())
      layer.name = tissue_names()[material];
    layers.push_back(layer);
  }
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(numbers[cell->material_id()]);
  return layers;
}


std::set<unsigned int> FileMesh::number_boundaries(Mesh &mesh) const
{
  std::set<unsigned int> numbers;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() > 0)
    {
      if (face->boundary_id() > 1000000000)
        refuse("faces have the number " + std::to_string(face->boundary_id()) +
               ", which must be at most 1000000000");
      numbers.insert(face->boundary_id());
      face->set_boundary_id(boundary_id(face->boundary_id()));
    }
  return numbers;
}


void FileMesh::cut_by_plane(Mesh &mesh, const unsigned int axis) const
{
  const auto box = dealii::GridTools::compute_bounding_box(mesh);
  const double place = box.lower_bound(axis);
  const double tolerance = 1e-6 * box.side_length(axis);
  const auto is_flat = [&](const auto &face) {
    for (unsigned int v = 0; v < 4; ++v)
      if (face->vertex(v)[axis] > place + tolerance)
        return false;
    return true;
  };
  // Twice the area of the mesh's projection along the axis.
  double seen = 0., flat = 0.;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
    {
      const double area =
        0.5 *
        std::abs(cross_product_3d(face->vertex(3) - face->vertex(0),
                                  face->vertex(2) - face->vertex(1))[axis]);
      seen += area;
      if (is_flat(face))
      {
        flat += area;
        face->set_boundary_id(1 + axis);
      }
    }
  // A whole rounded body has less flat area than this fraction.
  constexpr double least_part = 0.5;
  if (flat < least_part * 0.5 * seen)
    refuse("Mesh/Symmetry planes has " + std::string(1, "xyz"[axis]) +
           ", but the side at " + std::string(1, "xyz"[axis]) + " = " +
           brief(place) + " m is flat on " + brief(100. * flat / (0.5 * seen)) +
           " % of what the mesh covers; a mesh that is cut there has " +
           brief(100. * least_part) + " % at least");
}
} // namespace contrecoup::ale

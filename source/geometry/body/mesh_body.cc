// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/mesh_body.h>
#include <contrecoup/geometry/mesh/cell_shapes.h>
#include <contrecoup/geometry/mesh/hex_quality.h>
#include <contrecoup/geometry/mesh/mesh_file.h>
#include <contrecoup/geometry/mesh/mesh_format.h>
#include <contrecoup/geometry/mesh/mesh_smoothing.h>
#include <contrecoup/geometry/mesh/stray_cells.h>
#include <contrecoup/geometry/mesh/triangulation_hexes.h>
#include <contrecoup/geometry/shape/triangulated_surface.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  HexCorners corners_of(const HexMesh &mesh, const std::uint32_t cell)
  {
    HexCorners corners;
    for (unsigned int c = 0; c < 8; ++c)
      corners[c] = mesh.nodes[mesh.cells[cell][c]];
    return corners;
  }

  /// Position of each corner in the reference cube.
  constexpr double reference[8][3] = {{0., 0., 0.},
                                      {1., 0., 0.},
                                      {1., 1., 0.},
                                      {0., 1., 0.},
                                      {0., 0., 1.},
                                      {1., 0., 1.},
                                      {1., 1., 1.},
                                      {0., 1., 1.}};

  /// Reference coordinates of a point in a trilinear hexahedron, by Newton's
  /// method.
  Point<3> reference_coordinates(const HexCorners &corners,
                                 const Point<3> &point)
  {
    Point<3> place(0.5, 0.5, 0.5);
    for (unsigned int step = 0; step < 20; ++step)
    {
      Tensor<1, 3> residual = point;
      Tensor<2, 3> jacobian;
      for (unsigned int c = 0; c < 8; ++c)
      {
        std::array<double, 3> factor, slope;
        for (unsigned int d = 0; d < 3; ++d)
        {
          factor[d] = reference[c][d] > 0. ? place[d] : 1. - place[d];
          slope[d] = reference[c][d] > 0. ? 1. : -1.;
        }
        residual -= factor[0] * factor[1] * factor[2] * corners[c];
        for (unsigned int row = 0; row < 3; ++row)
        {
          jacobian[row][0] +=
            corners[c][row] * slope[0] * factor[1] * factor[2];
          jacobian[row][1] +=
            corners[c][row] * factor[0] * slope[1] * factor[2];
          jacobian[row][2] +=
            corners[c][row] * factor[0] * factor[1] * slope[2];
        }
      }
      const Tensor<1, 3> change = invert(jacobian) * residual;
      place += change;
      if (!(change.norm() > 1e-12))
        break;
    }
    return place;
  }

  ShapePointer skin_of(const HexMesh &mesh)
  {
    TriangleMesh skin;
    std::vector<std::uint32_t> number(mesh.nodes.size(), -1);
    for (const HexMesh::Facet &facet : mesh.boundary)
    {
      std::array<std::uint32_t, 4> corners;
      for (unsigned int v = 0; v < 4; ++v)
      {
        std::uint32_t &own = number[facet.nodes[v]];
        if (own == static_cast<std::uint32_t>(-1))
        {
          own = skin.vertices.size();
          skin.vertices.push_back(mesh.nodes[facet.nodes[v]]);
        }
        corners[v] = own;
      }
      skin.triangles.push_back({{corners[0], corners[1], corners[2]}});
      skin.triangles.push_back({{corners[0], corners[2], corners[3]}});
    }
    return std::make_shared<TriangulatedSurface>(std::move(skin));
  }
} // namespace


struct MeshBody::Search
{
  using Box = std::pair<dealii::BoundingBox<3>, std::uint32_t>;

  dealii::RTree<Box> boxes; ///< of the cells
};


MeshBody::MeshBody(HexMesh mesh)
  : mesh_(std::make_shared<const HexMesh>(std::move(mesh)))
  , surface_(skin_of(*mesh_))
{
  parts_ = mesh_->parts;
  std::vector<Search::Box> boxes;
  for (std::uint32_t cell = 0; cell < mesh_->cells.size(); ++cell)
  {
    const HexCorners corners = corners_of(*mesh_, cell);
    boxes.emplace_back(dealii::BoundingBox<3>(
                         std::vector<Point<3>>(corners.begin(), corners.end())),
                       cell);
  }
  search_ = std::make_shared<Search>(Search{dealii::pack_rtree(boxes)});
}

BodyPointer MeshBody::placed(const Placement &placement) const
{
  HexMesh mesh = *mesh_;
  for (Point<3> &node : mesh.nodes)
    node = placement.apply(node);
  const auto body = std::make_shared<MeshBody>(std::move(mesh));
  body->set_remarks(remarks());
  return body;
}

ShapePointer MeshBody::surface() const
{
  return surface_;
}

std::shared_ptr<const HexMesh> MeshBody::own_mesh() const
{
  return mesh_;
}

bool MeshBody::contains(const std::uint32_t cell, const Point<3> &point) const
{
  // A point on a common face must not be lost by round-off.
  constexpr double tolerance = 1e-9;
  const Point<3> place = reference_coordinates(corners_of(*mesh_, cell), point);
  for (unsigned int d = 0; d < 3; ++d)
    if (!(place[d] >= -tolerance && place[d] <= 1. + tolerance))
      return false;
  return true;
}

unsigned char MeshBody::part_at(const Point<3> &point) const
{
  std::vector<Search::Box> near;
  search_->boxes.query(boost::geometry::index::intersects(point),
                       std::back_inserter(near));
  std::uint32_t first = mesh_->cells.size();
  for (const auto &[box, cell] : near)
    if (cell < first && contains(cell, point))
      first = cell;
  return first < mesh_->cells.size() ? mesh_->part[first] : LabelGrid::outside;
}

void MeshBody::fill(LabelGrid &grid) const
{
  // Backwards, so that the first of several cells counts, as above.
  for (std::uint32_t cell = mesh_->cells.size(); cell-- > 0;)
  {
    const HexCorners corners = corners_of(*mesh_, cell);
    const dealii::BoundingBox<3> box(
      std::vector<Point<3>>(corners.begin(), corners.end()));
    std::array<unsigned int, 3> begin, end;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const auto index = [&](const double place) {
        const double number = (place - grid.origin[d]) / grid.spacing - 0.5;
        return std::min(std::max(number, 0.), double(grid.size[d]));
      };
      begin[d] = static_cast<unsigned int>(index(box.lower_bound(d)));
      end[d] = std::min(
        static_cast<unsigned int>(index(box.upper_bound(d))) + 2, grid.size[d]);
    }
    for (unsigned int k = begin[2]; k < end[2]; ++k)
      for (unsigned int j = begin[1]; j < end[1]; ++j)
        for (unsigned int i = begin[0]; i < end[0]; ++i)
          if (box.point_inside(grid.center(i, j, k)) &&
              contains(cell, grid.center(i, j, k)))
            grid.labels[grid.index(i, j, k)] = mesh_->part[cell];
  }
}


void MeshBodyDescription::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_file(prm,
               "File",
               "",
               "Mesh of 8-node hexahedra that share whole faces: " +
                 accepted_mesh_formats() +
                 ". Its hexahedra are those of the body; Element size has no "
                 "effect.");
  FileUnit::declare_parameters(prm);
  MeshGroups::declare_parameters(prm);
}

void MeshBodyDescription::parse_parameters(dealii::ParameterHandler &prm)
{
  file_ = prm.get("File");
  if (file_.empty())
    throw InputError("Body/Mesh/File is empty: it must name a mesh");
  unit_.parse_parameters(prm, "Body/Mesh");
  groups_.parse_parameters(prm, "Body/Mesh");
}

BodyPointer MeshBodyDescription::create(const double scale) const
{
  const std::string entry = "Body/Mesh/File";
  const std::string where = entry + " = " + file_;
  dealii::Triangulation<3> triangulation;
  const std::vector<std::string> lines =
    read_mesh_file(file_, entry, triangulation);
  check_cell_shapes(triangulation, where);
  if (const auto place = find_hanging_vertex(triangulation))
    throw InputError(where + ": the node at (" + brief((*place)[0]) + ", " +
                     brief((*place)[1]) + ", " + brief((*place)[2]) +
                     ") hangs amid a larger cell; cells must share whole "
                     "faces");
  HexMesh mesh = to_hex_mesh(
    triangulation, groups_.assign(read_group_names(file_, 3), triangulation));
  std::vector<Point<3>> scaled;
  for (Point<3> &node : mesh.nodes)
  {
    node *= unit_.length();
    scaled.push_back(scale * node);
  }
  unit_.require_size(where + ": ", dealii::BoundingBox<3>(scaled));
  double worst = 1.;
  for (const HexQuality &part : measure_quality(mesh))
    worst = std::min(worst, part.smallest_scaled_jacobian);
  const auto body = std::make_shared<MeshBody>(std::move(mesh));
  std::vector<std::string> parts;
  for (const BodyPart &part : body->parts())
    parts.push_back(part.name == name_of(part.tissue)
                      ? part.name
                      : part.name + " = " + name_of(part.tissue));
  std::vector<std::string> remarks = stray_warnings(*body->own_mesh());
  remarks.insert(remarks.begin(),
                 "mesh of " + std::to_string(body->own_mesh()->cells.size()) +
                   " hexahedra of your own: " + join(parts, ", "));
  remarks.insert(remarks.end(), lines.begin(), lines.end());
  if (worst < SmoothingOptions().smallest_scaled_jacobian)
    remarks.push_back("WARNING: " + where +
                      ": its worst hexahedron has a scaled Jacobian of " +
                      brief(worst, 2) + ", below " +
                      brief(SmoothingOptions().smallest_scaled_jacobian) +
                      ": stresses there are wrong and steps short");
  body->set_remarks(remarks);
  return body;
}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/base/parameters/tissue_list.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/mesh/hex_components.h>
#include <contrecoup/geometry/mesh/hex_quality.h>
#include <contrecoup/geometry/mesh/mesh_file.h>
#include <contrecoup/geometry/mesh/mesh_pieces.h>
#include <contrecoup/geometry/mesh/stray_cells.h>
#include <contrecoup/geometry/mesh/triangulation_hexes.h>
#include <contrecoup/solid/body/mesh_description.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::solid
{
namespace
{
  using dealii::Point;
  using Mesh = dealii::Triangulation<3>;

  /// Least length of all elements [m], see characteristic_length().
  double shortest_length(const HexMesh &mesh)
  {
    HexQuality all;
    for (const HexQuality &quality : measure_quality(mesh))
      all = all + quality;
    return all.shortest_length;
  }
} // namespace


void MeshDescription::parse_parameters(ParameterHandler &prm)
{
  for (const std::string &name : item_names(prm, "Mesh/Region"))
  {
    const Section section(prm, "Mesh");
    const Section region(prm, "Region " + name);
    regions_.push_back(
      {name,
       find_one_tissue(prm.get("Tissue"), "Mesh/Region " + name + "/Tissue"),
       Expression("Mesh/Region " + name + "/Where", prm.get("Where"))});
  }
  {
    const Section section(prm, "Mesh");
    parse_shape(prm);
  }
  if (kind_ == "body")
  {
    {
      const Section section(prm, "Body");
      body_.parse_parameters(prm);
    }
    layers_ = read_layers(prm);
  }
}


void MeshDescription::parse_shape(ParameterHandler &prm)
{
  kind_ = prm.get("Kind");
  lower_ = read_point<3>(prm, "Lower corner");
  upper_ = read_point<3>(prm, "Upper corner");
  for (unsigned int d = 0; d < 3; ++d)
    if (kind_ == "box" && !(lower_[d] < upper_[d]))
      throw InputError("Mesh/Upper corner must be above Mesh/Lower corner in "
                       "every direction");
  for (const double n : read_list(prm, "Elements"))
    elements_.push_back(static_cast<unsigned int>(n));
  for (const std::string &text : split(prm.get("Refined where"), ';'))
    refined_where_.emplace_back("Mesh/Refined where", text);
  distortion_ = read_double(prm, "Distortion");
  inner_radius_ = read_double(prm, "Inner radius");
  outer_radius_ = read_double(prm, "Outer radius");
  if (kind_ == "shell octant" && !(inner_radius_ < outer_radius_))
    throw InputError("Mesh/Inner radius must be below Mesh/Outer radius");
  refinements_ = read_unsigned(prm, "Refinements");
  file_ = prm.get("File");
  if (kind_ == "file" && file_.empty())
    throw InputError("Mesh/Kind = file needs Mesh/File");
  groups_.parse_parameters(prm, "Mesh");
  tissue_ = find_one_tissue(prm.get("Tissue"), "Mesh/Tissue");
  element_size_ = read_double(prm, "Element size");
  levels_ = read_unsigned(prm, "Coarsening levels");
  smoothing_.iterations = read_unsigned(prm, "Smoothing iterations");
  smoothing_.smallest_scaled_jacobian =
    read_double(prm, "Smallest scaled Jacobian");
}


double MeshDescription::estimate_elements() const
{
  const double finer = std::pow(8., refinements_);
  if (kind_ == "box")
    return double(elements_[0]) * elements_[1] * elements_[2];
  if (kind_ == "ball octant")
    return 4. * finer;
  if (kind_ == "shell octant")
    return 3. * finer;
  if (kind_ == "patch")
    return 7.;
  if (kind_ == "file")
    return static_cast<double>(from_triangulation().cells.size());
  const BodyPointer body = body_.create();
  if (const auto own = body->own_mesh())
    return static_cast<double>(own->cells.size());
  const auto box = body->surface()->bounding_box();
  LabelGrid grid =
    make_grid(box, std::max(element_size_, std::cbrt(box.volume() / 3e5)));
  body->fill(grid);
  const auto n_empty =
    std::count(grid.labels.begin(), grid.labels.end(), LabelGrid::outside);
  return grid.volume() / std::pow(element_size_, 3) *
         static_cast<double>(grid.labels.size() - n_empty);
}


double MeshDescription::estimate_step(const SolidMaterials &materials) const
{
  double size = element_size_;
  if (kind_ == "box")
  {
    size = upper_[0] - lower_[0];
    for (unsigned int d = 0; d < 3; ++d)
      size = std::min(size, (upper_[d] - lower_[d]) / elements_[d]);
    size *= std::pow(0.5, refined_where_.size());
  }
  else if (kind_ == "shell octant")
    size = std::min(outer_radius_ - inner_radius_, 0.8 * inner_radius_) *
           std::pow(0.5, refinements_);
  else if (kind_ == "ball octant")
    size = 0.3 * outer_radius_ * std::pow(0.5, refinements_);
  else if (kind_ == "patch")
    size = 0.2;
  double speed = 0.;
  std::vector<Tissue> tissues{tissue_};
  for (const Region &region : regions_)
    tissues.push_back(region.tissue);
  if (kind_ == "body")
  {
    // The loop alone would not keep the body alive.
    const BodyPointer body = body_.create();
    for (const BodyPart &part : body->parts())
      tissues.push_back(part.tissue);
    if (const auto own = body->own_mesh())
      size = shortest_length(*own);
  }
  for (const Tissue tissue : tissues)
    speed = std::max(speed, materials.find(tissue).dilatational_speed());
  return size / speed;
}


HexMesh MeshDescription::create() const
{
  HexMesh mesh = kind_ == "body" ? from_body() : from_triangulation();
  if (mesh.cells.empty())
    throw InputError("Mesh: no element is in the body; its Element size is " +
                     brief(element_size_) + " m");
  set_regions(mesh);
  return mesh;
}


double MeshDescription::phantom_mass() const
{
  return kind_ == "body" ? body_.phantom_mass()
                         : std::numeric_limits<double>::quiet_NaN();
}


std::set<std::string> MeshDescription::thin_parts(const HexMesh &mesh) const
{
  if (layers_.empty())
    return {};
  const auto n_pieces = count_components(mesh, mesh.part);
  const auto is_thin = [&](const std::size_t i) {
    return std::any_of(
      layers_.begin(), layers_.end(), [&](const BodyLayer &layer) {
        return mesh.parts[i].name == layer.part &&
               has_holes(layer, n_pieces[i], element_size_);
      });
  };
  std::set<std::string> found;
  for (std::size_t i = 0; i < mesh.parts.size(); ++i)
  {
    if (n_pieces[i] == 0 || !is_thin(i))
      continue;
    bool is_all = true; // of its tissue
    for (std::size_t j = 0; j < mesh.parts.size(); ++j)
      is_all = is_all && (mesh.parts[j].tissue != mesh.parts[i].tissue ||
                          n_pieces[j] == 0 || is_thin(j));
    found.insert(is_all ? name_of(mesh.parts[i].tissue) : mesh.parts[i].name);
  }
  return found;
}


HexMesh MeshDescription::from_body() const
{
  const BodyPointer body = body_.create();
  log_warnings(*body);
  if (const auto own = body->own_mesh())
    return *own;
  LabelGrid grid = make_grid(body->surface()->bounding_box(), element_size_);
  body->fill(grid);
  for (const std::string &line : join_strays(body->parts(), grid))
    log_line(line);
  if (const std::string line =
        pieces_warning("the body", count_components(grid)[LabelGrid::outside]);
      !line.empty())
    log_line(line);
  HexMesh mesh = make_hex_mesh(grid, body->parts(), levels_);
  if (smoothing_.iterations > 0)
    smooth(mesh, smoothing_);
  if (const std::string line =
        organ_warning(check_organs(mesh, body_.references()));
      !line.empty())
    log_line(line);
  return mesh;
}


HexMesh MeshDescription::from_triangulation() const
{
  Mesh mesh;
  std::vector<BodyPart> parts{{kind_, tissue_}};
  if (kind_ == "file")
  {
    for (const std::string &line : read_mesh_file(file_, "Mesh/File", mesh))
      log_line(line);
    parts = groups_.assign(read_group_names(file_, 3), mesh);
    mesh.refine_global(refinements_);
  }
  else
    make_shape(mesh);
  HexMesh result = to_hex_mesh(mesh, parts);
  if (kind_ == "file")
    for (const std::string &line : stray_warnings(result))
      log_line(line);
  return result;
}


void MeshDescription::make_shape(Mesh &mesh) const
{
  if (kind_ == "patch")
    return make_patch(mesh);
  if (kind_ == "box")
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, elements_, lower_, upper_);
    refine(mesh);
    if (distortion_ > 0.)
      distort(mesh, distortion_);
    return;
  }
  if (kind_ == "shell octant")
    dealii::GridGenerator::quarter_hyper_shell(
      mesh, Point<3>(), inner_radius_, outer_radius_, 3);
  else
  {
    dealii::GridGenerator::quarter_hyper_ball(mesh, Point<3>(), outer_radius_);
    mesh.reset_all_manifolds();
    mesh.set_all_manifold_ids(1);
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f) &&
            cell->face(f)->center().norm() > 0.6 * outer_radius_)
        {
          bool round = true;
          for (const unsigned int v : cell->face(f)->vertex_indices())
            round = round && cell->face(f)->vertex(v).norm() >
                               (1. - 1e-9) * outer_radius_;
          if (round)
            cell->face(f)->set_all_manifold_ids(0);
        }
    mesh.set_manifold(0, dealii::SphericalManifold<3>());
    dealii::TransfiniteInterpolationManifold<3> inside;
    inside.initialize(mesh);
    mesh.set_manifold(1, inside);
  }
  mesh.refine_global(refinements_);
}


void MeshDescription::make_patch(Mesh &mesh) const
{
  // MacNeal and Harder 1985: the unit cube around a distorted element.
  const std::vector<Point<3>> points{{0., 0., 0.},
                                     {1., 0., 0.},
                                     {1., 1., 0.},
                                     {0., 1., 0.},
                                     {0., 0., 1.},
                                     {1., 0., 1.},
                                     {1., 1., 1.},
                                     {0., 1., 1.},
                                     {.249, .342, .192},
                                     {.826, .288, .288},
                                     {.850, .649, .263},
                                     {.273, .750, .230},
                                     {.320, .186, .643},
                                     {.677, .305, .683},
                                     {.788, .693, .644},
                                     {.165, .745, .702}};
  const unsigned int hexes[7][8] = {{8, 9, 10, 11, 12, 13, 14, 15},
                                    {0, 1, 2, 3, 8, 9, 10, 11},
                                    {12, 13, 14, 15, 4, 5, 6, 7},
                                    {0, 1, 9, 8, 4, 5, 13, 12},
                                    {1, 2, 10, 9, 5, 6, 14, 13},
                                    {2, 3, 11, 10, 6, 7, 15, 14},
                                    {3, 0, 8, 11, 7, 4, 12, 15}};
  std::vector<dealii::CellData<3>> cells;
  for (const auto &hex : hexes)
  {
    dealii::CellData<3> cell(8);
    for (unsigned int v = 0; v < 8; ++v)
      cell.vertices[v] = hex[vertex_of_corner[v]];
    cell.material_id = 0;
    cells.push_back(cell);
  }
  mesh.create_triangulation(points, cells, {});
}


void MeshDescription::refine(Mesh &mesh) const
{
  for (const Expression &where : refined_where_)
  {
    std::uint64_t count = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      if (where.value(cell->center()) != 0.)
      {
        cell->set_refine_flag();
        ++count;
      }
    Selections selections;
    selections.add("Mesh/Refined where", where.text(), "element", count);
    selections.require_some(MPI_COMM_SELF, "it must be true at their centres");
    mesh.execute_coarsening_and_refinement();
  }
}


void MeshDescription::set_regions(HexMesh &mesh) const
{
  Selections selections;
  for (const Region &region : regions_)
  {
    std::uint64_t count = 0;
    const auto part = static_cast<unsigned char>(mesh.parts.size());
    mesh.parts.push_back({name_of(region.tissue), region.tissue});
    for (std::size_t i = 0; i < mesh.cells.size(); ++i)
    {
      Point<3> centre;
      for (const std::uint32_t node : mesh.cells[i])
        centre += mesh.nodes[node] / 8.;
      if (region.where.value(centre) == 0.)
        continue;
      mesh.part[i] = part;
      ++count;
    }
    selections.add("Mesh/Region " + region.name + "/Where",
                   region.where.text(),
                   "element",
                   count);
  }
  // Each rank has the whole mesh.
  selections.require_some(MPI_COMM_SELF, "it must be true at their centres");
}
} // namespace contrecoup::solid

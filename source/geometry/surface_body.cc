// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/base/text.h>
#include <contrecoup/geometry/placement.h>
#include <contrecoup/geometry/surface_body.h>
#include <contrecoup/geometry/triangle_intersections.h>
#include <contrecoup/geometry/triangle_repair.h>
#include <contrecoup/geometry/triangulated_surface.h>

namespace contrecoup
{
namespace
{
  const std::vector<std::pair<std::string, double>> &units()
  {
    static const std::vector<std::pair<std::string, double>> table{
      {"m", 1.}, {"cm", 1e-2}, {"mm", 1e-3}, {"inch", 0.0254}};
    return table;
  }

  /// Says of a surface what makes its body doubtful.
  std::vector<std::string> make_remarks(const TriangleMesh &mesh,
                                        const RepairReport &report)
  {
    std::vector<std::string> remarks{
      "surface of " + std::to_string(report.n_triangles) + " triangles in " +
      std::to_string(report.n_pieces) + " piece(s), " + brief(mesh.area()) +
      " m^2 around " + brief(1e3 * mesh.volume()) + " litre"};
    for (const std::string &line : report.lines())
      remarks.push_back(line);
    constexpr std::size_t most = 1000;
    const auto pairs = find_self_intersections(mesh, most);
    if (!pairs.empty())
    {
      const dealii::Point<3> &place = pairs.front().place;
      remarks.push_back(
        (pairs.size() == most ? "at least " : "") +
        std::to_string(pairs.size()) +
        " pair(s) of triangles pass through each other, the first near " +
        brief(place[0]) + ", " + brief(place[1]) + ", " + brief(place[2]) +
        " m; what is around more than once counts as inside");
    }
    return remarks;
  }
} // namespace


void SurfaceBody::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_file(prm,
               "File",
               "",
               "Surface of triangles: STL (binary or ASCII), OBJ, PLY or what "
               "else Assimp reads.");
  std::vector<std::string> names;
  for (const auto &[name, length] : units())
    names.push_back(name);
  declare_selection(prm, "Unit", "m", names, "The length of a 1 in the file.");
  Placement::declare_rotation(
    prm,
    "Angles about the fixed axes x, then y, then z that turn what the file "
    "has, before all else.");
  declare_selection(prm,
                    "Tissue",
                    "soft tissue",
                    {tissue_names().begin() + 1, tissue_names().end()},
                    "What the body is made of.");
  declare_selection(prm,
                    "Organs",
                    "none",
                    {"none", "phantom"},
                    "What is inside: nothing but that tissue, or the organs "
                    "of the phantom (subsection Phantom) scaled to the "
                    "surface's height; then the person, turned by Rotation, "
                    "must stand upright along z and face +x.");
  declare_double(prm,
                 "Largest loss of organs",
                 "0.1",
                 0.,
                 1.,
                 "-",
                 "Part of the organs' volume that may be outside of the "
                 "surface.");
  declare_double(prm,
                 "Largest holes",
                 "0.05",
                 0.,
                 1.,
                 "-",
                 "Area of all holes that are closed over that of the surface; "
                 "0 to 1, larger holes are refused.");
}

void SurfaceBody::parse_parameters(dealii::ParameterHandler &prm)
{
  file_ = prm.get("File");
  if (file_.empty())
    throw InputError("Body/Surface/File is empty: it must name a surface");
  for (const auto &[name, length] : units())
    if (name == prm.get("Unit"))
      unit_ = length;
  angles_ = Placement::read_rotation(prm);
  tissue_ = find_tissue(prm.get("Tissue"));
  has_organs_ = prm.get("Organs") == "phantom";
  largest_loss_ = read_double(prm, "Largest loss of organs");
  largest_hole_area_ = read_double(prm, "Largest holes");
}

BodyPointer SurfaceBody::create() const
{
  TriangleMesh mesh = read_surface(file_, unit_);
  const Placement turned(1., angles_, {});
  for (dealii::Point<3> &vertex : mesh.vertices)
    vertex = turned.apply(vertex);
  const RepairReport report = repair(mesh);
  const std::string where = "surface \"" + file_ + "\": ";
  if (mesh.triangles.empty())
    throw InputError(where + "no triangle has an area");
  const double hole_share = report.hole_area / mesh.area();
  if (hole_share > largest_hole_area_)
    throw InputError(where + std::to_string(report.n_holes) + " hole(s) have " +
                     brief(100. * hole_share, 3) +
                     " % of the area; Body/Surface/Largest holes allows " +
                     brief(100. * largest_hole_area_, 3) + " %");
  if (!(mesh.volume() > 1e-9 * std::pow(mesh.area(), 1.5)))
    throw InputError(where + "it encloses no volume (" + brief(mesh.volume()) +
                     " m^3 in " + brief(mesh.area()) + " m^2)");
  const std::vector<std::string> remarks = make_remarks(mesh, report);
  const auto shape = std::make_shared<TriangulatedSurface>(std::move(mesh));
  const auto body = std::make_shared<ShapeBody>(
    shape, std::vector<ShapeBody::Piece>{{{name_of(tissue_), tissue_}, shape}});
  body->set_remarks(remarks);
  return body;
}
} // namespace contrecoup

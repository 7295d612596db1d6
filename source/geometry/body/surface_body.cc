// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/tissue_list.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/surface_body.h>
#include <contrecoup/geometry/shape/placement.h>
#include <contrecoup/geometry/shape/triangle_intersections.h>
#include <contrecoup/geometry/shape/triangle_repair.h>
#include <contrecoup/geometry/shape/triangulated_surface.h>

namespace contrecoup
{
namespace
{
  const std::string found = "found";

  /// Angle of the front of a person [degrees]; nothing: to be found.
  std::optional<double> read_facing(const dealii::ParameterHandler &prm)
  {
    const std::string text = prm.get("Facing");
    if (text == found)
      return {};
    const dealii::Patterns::Double allowed(-360., 360.);
    if (!allowed.match(text))
      throw InputError("entry \"Body/Surface/Facing\" cannot be \"" + text +
                       "\"; allowed: " + found +
                       ", or a number from -360 to 360 [degrees]");
    return dealii::Utilities::string_to_double(text);
  }


  /// Height of the neck of a person [m]; nothing: to be found.
  std::optional<double> read_neck(const dealii::ParameterHandler &prm)
  {
    const std::string text = prm.get("Neck height");
    if (text == found)
      return {};
    const dealii::Patterns::Double allowed(0.1, 3.);
    if (!allowed.match(text))
      throw InputError("entry \"Body/Surface/Neck height\" cannot be \"" +
                       text + "\"; allowed: " + found +
                       ", or a number from 0.1 to 3 [m]");
    return dealii::Utilities::string_to_double(text);
  }


  /// Adds remarks on size and defects of a surface.
  void add_remarks(const TriangleMesh &mesh,
                   const RepairReport &report,
                   std::vector<std::string> &remarks)
  {
    const auto counted = [](const std::size_t n, const std::string &what) {
      return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
    };
    remarks.push_back("surface of " + counted(report.n_triangles, "triangle") +
                      " in " + counted(report.n_pieces, "piece") + ", " +
                      brief(mesh.area()) + " m^2 around " +
                      brief(1e3 * mesh.volume()) + " litre");
    for (const std::string &line : report.lines())
      remarks.push_back(line);
    constexpr std::size_t most = 1000;
    const auto pairs = find_self_intersections(mesh, most);
    if (!pairs.empty())
    {
      const dealii::Point<3> &place = pairs.front().place;
      remarks.push_back(
        (pairs.size() == most ? "at least " : "") +
        counted(pairs.size(), "pair") +
        " of triangles pass through each other, the first near " +
        coordinates(place) +
        " m; what is enclosed more than once is inside, and counts as often "
        "in the volume");
    }
  }

  /// Entries of a person with organs.
  void declare_organs(dealii::ParameterHandler &prm)
  {
    declare_selection(
      prm,
      "Organs",
      "none",
      {"none", "phantom"},
      "Interior of the body: the given tissue only, or with "
      "the organs of the phantom (subsection Phantom), warped "
      "section by section to the surface of one person who stands, "
      "sits or lies, in any direction.");
    const UsedWith used("Body/Surface/Organs = phantom");
    declare_string(
      prm,
      "Facing",
      found,
      "Angle of the front of a standing person with organs from +x "
      "about z [degrees, -360 to 360], after Rotation; found: by "
      "trunk and feet.");
    declare_string(
      prm,
      "Neck height",
      found,
      "Height of the thinnest section of the neck of a person with organs above "
      "the soles [m, 0.1 to 3], before Scale; found: the least section at 75 to "
      "92 % of the height.");
    declare_selection(prm,
                      "Posture",
                      "standing",
                      {"standing", "as given"},
                      "Whether a person with organs who lies in the file is "
                      "stood up along z, facing +x, or stays as given; who "
                      "stands is not turned.");
    declare_double(
      prm,
      "Largest loss of organs",
      "0.1",
      0.,
      1.,
      "-",
      "Fraction of the organs' volume that may be outside the surface.");
  }
} // namespace


void SurfaceBody::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_file(prm,
               "File",
               "",
               "Triangulated surface: STL (binary or ASCII), OBJ or PLY, or "
               "in single precision another format that Assimp reads.");
  FileUnit::declare_parameters(prm);
  Placement::declare_rotation(prm,
                              "Angles about the fixed axes x, then y, then "
                              "z that rotate the surface of the file before "
                              "all else.");
  declare_string(
    prm,
    "Tissue",
    "soft tissue",
    "Tissue of the body: one of " +
      join({tissue_names().begin() + 1, tissue_names().end()}, ", ") +
      ", or of the user's own.");
  declare_organs(prm);
  declare_double(prm,
                 "Largest holes",
                 "0.05",
                 0.,
                 1.,
                 "-",
                 "Area of all closed holes over that of the surface, 0 to "
                 "1; larger holes are refused.");
}

void SurfaceBody::parse_parameters(dealii::ParameterHandler &prm)
{
  file_ = prm.get("File");
  if (file_.empty())
    throw InputError("Body/Surface/File is empty: it must name a surface");
  unit_.parse_parameters(prm, "Body/Surface");
  angles_ = Placement::read_rotation(prm);
  tissue_ = find_one_tissue(prm.get("Tissue"), "Body/Surface/Tissue");
  has_organs_ = prm.get("Organs") == "phantom";
  insertion_.largest_loss = read_double(prm, "Largest loss of organs");
  insertion_.facing = read_facing(prm);
  insertion_.neck_height = read_neck(prm);
  insertion_.stands_up = prm.get("Posture") == "standing";
  largest_hole_area_ = read_double(prm, "Largest holes");
}

BodyPointer SurfaceBody::create(const double scale) const
{
  std::vector<std::string> remarks;
  TriangleMesh mesh = read_surface(file_, unit_.length(), &remarks);
  const Placement turned(1., angles_, {});
  std::vector<dealii::Point<3>> scaled;
  for (dealii::Point<3> &vertex : mesh.vertices)
  {
    vertex = turned.apply(vertex);
    scaled.push_back(scale * vertex);
  }
  const std::string where = "surface \"" + file_ + "\": ";
  if (!scaled.empty())
    unit_.require_size(where, dealii::BoundingBox<3>(scaled), has_organs_);
  const RepairReport report = repair(mesh);
  if (mesh.triangles.empty())
    throw InputError(where + "no triangle has an area");
  if (2 * report.n_degenerate > report.n_triangles)
    throw InputError(where + std::to_string(report.n_degenerate) + " of its " +
                     std::to_string(report.n_triangles) +
                     " triangles have no area or are given twice; far from "
                     "the origin, positions in single precision coincide: move "
                     "the surface there, or save it as OBJ or PLY with all "
                     "digits");
  const double hole_share = report.hole_area / mesh.area();
  if (hole_share > largest_hole_area_)
    throw InputError(where + std::to_string(report.n_holes) + " hole(s) have " +
                     brief(100. * hole_share, 3) +
                     " % of the area; Body/Surface/Largest holes allows " +
                     brief(100. * largest_hole_area_, 3) + " %");
  if (!(mesh.volume() > 1e-9 * std::pow(mesh.area(), 1.5)))
    throw InputError(where + "it encloses no volume (" + brief(mesh.volume()) +
                     " m^3 in " + brief(mesh.area()) + " m^2)");
  add_remarks(mesh, report, remarks);
  const auto shape = std::make_shared<TriangulatedSurface>(std::move(mesh));
  const auto body = std::make_shared<ShapeBody>(
    shape,
    std::vector<ShapeBody::PartShape>{{{name_of(tissue_), tissue_}, shape}});
  body->set_remarks(remarks);
  return body;
}
} // namespace contrecoup

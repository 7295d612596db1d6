// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/tissue_list.h>
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
  const std::vector<std::pair<std::string, double>> &units()
  {
    static const std::vector<std::pair<std::string, double>> table{
      {"m", 1.}, {"cm", 1e-2}, {"mm", 1e-3}, {"inch", 0.0254}};
    return table;
  }

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


  /// Remarks on defects of a surface.
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
      "section by section to the surface of one adult, from the "
      "soles to the vertex, in any direction.");
    declare_string(
      prm,
      "Facing",
      found,
      "Angle of the front of a standing person with organs from +x "
      "about z [degrees, -360 to 360], after Rotation; found: by "
      "trunk and feet.");
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
               "Triangulated surface: STL (binary or ASCII), OBJ, PLY or "
               "another format that Assimp reads.");
  std::vector<std::string> names;
  for (const auto &[name, length] : units())
    names.push_back(name);
  declare_selection(prm, "Unit", "m", names, "Length of a 1 in the file.");
  declare_double(prm,
                 "Largest size",
                 "5",
                 1e-6,
                 1e6,
                 "m",
                 "Longest edge of the bounding box, including the scale of "
                 "Body, above which the body is refused because Unit is "
                 "probably wrong.");
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
  for (const auto &[name, length] : units())
    if (name == prm.get("Unit"))
      unit_ = length;
  largest_size_ = read_double(prm, "Largest size");
  angles_ = Placement::read_rotation(prm);
  tissue_ = find_one_tissue(prm.get("Tissue"), "Body/Surface/Tissue");
  has_organs_ = prm.get("Organs") == "phantom";
  insertion_.largest_loss = read_double(prm, "Largest loss of organs");
  insertion_.facing = read_facing(prm);
  insertion_.stands_up = prm.get("Posture") == "standing";
  largest_hole_area_ = read_double(prm, "Largest holes");
}

void SurfaceBody::check_size(const dealii::BoundingBox<3> &box) const
{
  // Limits for a person with organs, and for other bodies.
  constexpr double smallest_person = 0.3, largest_person = 2.6;
  double size = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    size = std::max(size, box.side_length(d));
  const double smallest = has_organs_ ? smallest_person : 0.;
  const double largest =
    has_organs_ ? std::min(largest_size_, largest_person) : largest_size_;
  if (size >= smallest && size <= largest)
    return;
  // A head may be scanned alone.
  constexpr double smallest_likely = 0.1;
  std::vector<std::string> better;
  for (const auto &[name, length] : units())
  {
    const double other = size * length / unit_;
    if (length != unit_ && other >= std::max(smallest, smallest_likely) &&
        other <= std::min(largest, largest_person))
      better.push_back("Body/Surface/Unit = " + name + " would make it " +
                       brief(other) + " m");
  }
  throw InputError(
    "surface \"" + file_ + "\": its box is " + brief(box.side_length(0)) +
    " x " + brief(box.side_length(1)) + " x " + brief(box.side_length(2)) +
    " m, " +
    (has_organs_
       ? "that of a person is " + brief(smallest) + " to " + brief(largest) +
           " m long"
       : "Body/Surface/Largest size allows " + brief(largest) + " m") +
    (better.empty() ? std::string("; Body/Surface/Unit or "
                                  "Body/Scale changes it")
                    : "; " + join(better, ", ")));
}

BodyPointer SurfaceBody::create(const double scale) const
{
  TriangleMesh mesh = read_surface(file_, unit_);
  const Placement turned(1., angles_, {});
  std::vector<dealii::Point<3>> scaled;
  for (dealii::Point<3> &vertex : mesh.vertices)
  {
    vertex = turned.apply(vertex);
    scaled.push_back(scale * vertex);
  }
  if (!scaled.empty())
    check_size(dealii::BoundingBox<3>(scaled));
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
    shape,
    std::vector<ShapeBody::PartShape>{{{name_of(tissue_), tissue_}, shape}});
  body->set_remarks(remarks);
  return body;
}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/geometry/body/inserted_organs.h>
#include <contrecoup/geometry/shape/composed_shapes.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace contrecoup
{
namespace
{
  /// State of a file, and of the voxel file that belongs to a header.
  std::string fingerprint(const std::filesystem::path &file)
  {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored))
      return "none";
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    const std::string own =
      std::to_string(text.str().size()) + " " +
      std::to_string(std::hash<std::string>()(text.str()));
    if (file.extension() != ".hdr")
      return own;
    return own + " " +
           fingerprint(std::filesystem::path(file).replace_extension(".img"));
  }

  /// Entries, with their subsections, that define a body before placement.
  std::vector<std::vector<std::string>> names_of_origin()
  {
    dealii::ParameterHandler prm;
    BodyDescription::declare_parameters(prm);
    std::vector<std::vector<std::string>> names;
    for (const auto &entry : parameter_values(prm))
    {
      const std::vector<std::string> words = split(entry.first, '/');
      if (words.size() > 1 || words[0] == "Kind" || words[0] == "Scale")
        names.push_back(words);
    }
    return names;
  }

  /// Volumes of the voxels of an image, of parts of the same name together.
  std::vector<OrganReference> references_of(const Body &body)
  {
    const auto volumes = dynamic_cast<const ImageBody &>(body).part_volumes();
    std::map<std::string, double> sums;
    for (std::size_t i = 0; i < volumes.size(); ++i)
      sums[body.parts()[i].name] += volumes[i];
    std::vector<OrganReference> references;
    for (const auto &[name, volume] : sums)
      if (volume > 0.)
        references.push_back({name, {name}, volume, 0.1, "the image"});
    return references;
  }

  double shortest_side(const dealii::BoundingBox<3> &box)
  {
    return std::min(
      {box.side_length(0), box.side_length(1), box.side_length(2)});
  }

  /// The own_box() of a shape as its file has it, or, where that is narrower by
  /// more than a tenth, of the shape turned about one axis.
  dealii::BoundingBox<3> narrowest_box(const ShapePointer &shape)
  {
    constexpr double quarter = 90., step = 15., finest = 1., least_gain = 0.9,
                     degree = dealii::numbers::PI / 180.;
    const auto turned_box = [&](const unsigned int axis, const double angle) {
      return own_box(PlacedShape(
        shape,
        Placement(
          1., angle * degree * dealii::Point<3>::unit_vector(axis), {})));
    };
    const dealii::BoundingBox<3> as_given = own_box(*shape);
    dealii::BoundingBox<3> narrowest = as_given;
    unsigned int axis = 0;
    double best = 0.;
    const auto consider = [&](const unsigned int about, const double angle) {
      const auto box = turned_box(about, angle);
      if (shortest_side(box) < shortest_side(narrowest))
      {
        narrowest = box;
        axis = about;
        best = angle;
      }
    };
    for (unsigned int d = 0; d < 3; ++d)
      for (double angle = step; angle < quarter; angle += step)
        consider(d, angle);
    for (double change = 0.5 * step; change > finest; change *= 0.5)
    {
      const double middle = best;
      consider(axis, middle - change);
      consider(axis, middle + change);
    }
    return shortest_side(narrowest) < least_gain * shortest_side(as_given)
             ? narrowest
             : as_given;
  }
} // namespace

void BodyDescription::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_selection(prm,
                    "Kind",
                    "phantom",
                    {"phantom", "shape", "surface", "image", "mesh"},
                    "The human phantom, a simple shape, a triangulated "
                    "surface from a file, a medical image, or hexahedra from "
                    "a file.");
  declare_selection(prm,
                    "Origin",
                    "as given",
                    {"as given", "middle", "bottom"},
                    "Reference point of the scaled and rotated body, which "
                    "Shift moves away from the origin: its own origin, the "
                    "centre of its bounding box, or the bottom centre of "
                    "that box.");
  Placement::declare_parameters(prm);
  {
    const Section section(prm, "Phantom");
    const UsedWith used("Body/Kind or Body/Surface/Organs = phantom");
    Phantom::declare_parameters(prm);
  }
  {
    const Section section(prm, "Shape");
    const UsedWith used("Body/Kind = shape");
    SimpleBody::declare_parameters(prm);
  }
  {
    const Section section(prm, "Surface");
    const UsedWith used("Body/Kind = surface");
    SurfaceBody::declare_parameters(prm);
  }
  {
    const Section section(prm, "Image");
    const UsedWith used("Body/Kind = image");
    ImageDescription::declare_parameters(prm);
  }
  const Section section(prm, "Mesh");
  const UsedWith used("Body/Kind = mesh");
  MeshBodyDescription::declare_parameters(prm);
}

double BodyDescription::phantom_mass() const
{
  return kind_ == "phantom" ? std::pow(scale_, 3) * phantom_.mass()
                            : std::numeric_limits<double>::quiet_NaN();
}

void BodyDescription::parse_parameters(dealii::ParameterHandler &prm)
{
  static const auto names = names_of_origin();
  text_.clear();
  files_.clear();
  for (std::vector<std::string> path : names)
  {
    const std::string entry = path.back();
    path.pop_back();
    text_ += prm.get(path, entry) + "\n";
    if (entry == "File" || entry == "Brain mask")
      files_.push_back(prm.get(path, entry));
  }
  kind_ = prm.get("Kind");
  origin_ = prm.get("Origin");
  placement_.parse_parameters(prm);
  scale_ = read_double(prm, "Scale");
  if (kind_ == "phantom")
  {
    const Section section(prm, "Phantom");
    phantom_.parse_parameters(prm);
  }
  else if (kind_ == "surface")
  {
    {
      const Section section(prm, "Surface");
      from_surface_.parse_parameters(prm);
    }
    const Section section(prm, "Phantom");
    if (from_surface_.has_organs())
      phantom_.parse_parameters(prm);
  }
  else if (kind_ == "image")
  {
    const Section section(prm, "Image");
    from_image_.parse_parameters(prm);
  }
  else if (kind_ == "mesh")
  {
    const Section section(prm, "Mesh");
    from_mesh_.parse_parameters(prm);
  }
  else
  {
    const Section section(prm, "Shape");
    simple_.parse_parameters(prm);
  }
}

BodyPointer BodyDescription::create_unplaced() const
{
  if (kind_ == "phantom")
    return phantom_.create();
  if (kind_ == "surface")
  {
    const BodyPointer body = from_surface_.create(placement_.scale());
    if (!from_surface_.has_organs())
      return body;
    ShapeBody donor =
      *std::dynamic_pointer_cast<const ShapeBody>(phantom_.create());
    donor.set_remarks(
      {"the phantom of these organs has " +
       brief(donor.surface()->bounding_box().side_length(2), 4) + " m and " +
       brief(phantom_.mass(), 3) +
       " kg (Body/Phantom), the person what the surface has"});
    return insert_organs(
      *body, donor, from_surface_.insertion(placement_.scale()));
  }
  if (kind_ == "image")
    return from_image_.create();
  if (kind_ == "mesh")
    return from_mesh_.create(placement_.scale());
  return simple_.create();
}

BodyPointer BodyDescription::unplaced() const
{
  // Plan, stages and trial runs of a scene create the same body, whose images
  // may take seconds to read.
  static std::string last_text;
  static BodyPointer last;
  std::string text = text_;
  for (const std::string &file : files_)
    text += fingerprint(file) + "\n";
  if (!last || last_text != text)
  {
    last.reset();
    last = create_unplaced();
    last_text = text;
  }
  return last;
}

BodyPointer BodyDescription::create() const
{
  BodyPointer body = unplaced();
  if (!placement_.is_identity())
    body = body->placed(placement_);
  if (origin_ == "as given")
    return body;
  // The placement includes the shift; now move the reference point there.
  const auto box = body->surface()->bounding_box();
  dealii::Point<3> point = box.center();
  if (origin_ == "bottom")
    point[2] = box.lower_bound(2);
  return body->placed(
    Placement(1., dealii::Tensor<1, 3>(), placement_.shift() - point));
}

dealii::BoundingBox<3> BodyDescription::unturned_box() const
{
  return Placement(placement_.scale(), {}, {})
    .apply(kind_ == "phantom" ? own_box(*unplaced()->surface())
                              : narrowest_box(unplaced()->surface()));
}

std::vector<OrganReference> BodyDescription::references() const
{
  if (kind_ == "image")
    return references_of(*create());
  if (kind_ == "phantom" && placement_.scale() == 1.)
    return phantom_.references();
  return {};
}
} // namespace contrecoup

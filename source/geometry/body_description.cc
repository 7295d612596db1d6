// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters.h>
#include <contrecoup/geometry/body_description.h>
#include <contrecoup/geometry/borrowed_organs.h>

namespace contrecoup
{
void BodyDescription::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_selection(prm,
                    "Kind",
                    "phantom",
                    {"phantom", "shape", "surface", "image"},
                    "Where the body comes from: the human phantom, a simple "
                    "shape, a surface of triangles from a file, or a medical "
                    "image.");
  declare_selection(prm,
                    "Origin",
                    "as given",
                    {"as given", "middle", "bottom"},
                    "Which point of the scaled and turned body Shift moves "
                    "from the origin: the origin of its own coordinates, the "
                    "middle of the box around it, or the middle of the bottom "
                    "of that box.");
  Placement::declare_parameters(prm);
  {
    const Section section(prm, "Phantom");
    Phantom::declare_parameters(prm);
  }
  {
    const Section section(prm, "Shape");
    SimpleBody::declare_parameters(prm);
  }
  {
    const Section section(prm, "Surface");
    SurfaceBody::declare_parameters(prm);
  }
  const Section section(prm, "Image");
  ImageDescription::declare_parameters(prm);
}

void BodyDescription::parse_parameters(dealii::ParameterHandler &prm)
{
  kind_ = prm.get("Kind");
  origin_ = prm.get("Origin");
  placement_.parse_parameters(prm);
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
    const auto giver =
      std::dynamic_pointer_cast<const ShapeBody>(phantom_.create());
    return borrow_organs(*body, *giver, from_surface_.largest_loss());
  }
  if (kind_ == "image")
    return from_image_.create();
  return simple_.create();
}

BodyPointer BodyDescription::create() const
{
  BodyPointer body = create_unplaced();
  if (!placement_.is_identity())
    body = body->placed(placement_);
  if (origin_ == "as given")
    return body;
  // The shift has been made already; the point is brought to where it points.
  const auto box = body->surface()->bounding_box();
  dealii::Point<3> point = box.center();
  if (origin_ == "bottom")
    point[2] = box.lower_bound(2);
  return body->placed(
    Placement(1., dealii::Tensor<1, 3>(), placement_.shift() - point));
}

std::vector<OrganReference> BodyDescription::references() const
{
  if (kind_ == "phantom" && placement_.scale() == 1.)
    return phantom_.references();
  return {};
}
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/inserted_organs.h>
#include <contrecoup/geometry/body/organ_fit.h>
#include <contrecoup/geometry/body/person_posture.h>
#include <contrecoup/geometry/body/person_sections.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>
#include <contrecoup/geometry/shape/triangle_smoothing.h>
#include <contrecoup/geometry/shape/triangulated_surface.h>

namespace contrecoup
{
using dealii::Point;

namespace
{
  using PartShape = ShapeBody::PartShape;
  using Warps = std::array<SectionWarp, n_regions>;

  bool is_organ(const BodyPart &part)
  {
    return part.tissue != Tissue::skin && part.tissue != Tissue::soft_tissue;
  }


  PosedPerson find_person(const Shape &skin, const OrganInsertion &insertion)
  {
    try
    {
      return find_posture(skin, insertion.facing, insertion.neck_height);
    }
    catch (const InputError &error)
    {
      throw InputError(
        "Body/Surface/Organs = phantom: the surface must be that of one person "
        "from the soles to the vertex who stands, sits or lies, but " +
        std::string(error.what()) +
        "; Body/Surface/Organs = none takes it as one tissue");
    }
  }


  /// A number to one decimal, without a sign of zero.
  std::string tenths(const double value)
  {
    return brief(std::round(10. * value) / 10. + 0.);
  }


  std::vector<std::string> posture_remarks(const PosedPerson &person,
                                           const bool stands_up)
  {
    const Posture &posture = person.posture;
    std::vector<std::string> remarks;
    const auto angles = posture.angles();
    std::string rotation;
    for (unsigned int d = 0; d < 3; ++d)
      rotation += (d > 0 ? ", " : "") + tenths(angles[d]);
    const std::string source = posture.face_agrees
                                 ? " (feet and face agree)"
                                 : " (by the feet; the face points elsewhere)";
    if (posture.is_standing)
      remarks.push_back(
        "before Body/Rotation the person faces " +
        direction_name(posture.forward) + ", " + tenths(posture.facing()) +
        " degrees from +x about z" + source +
        "; Body/Surface/Facing sets another angle" +
        (std::abs(posture.facing()) > 2.
           ? ", Body/Surface/Rotation = " + rotation + " turns them to +x"
           : ""));
    else
      remarks.push_back(
        "the person lies in the file with the head to " +
        direction_name(posture.up) + ", facing " +
        direction_name(posture.forward) + source +
        (stands_up
           ? ", and is stood up along z to face +x, as by "
             "Body/Surface/Rotation = " +
               rotation + "; Body/Surface/Posture = as given prevents it"
           : "; Body/Surface/Posture = standing would stand them up"));
    if (person.regions.thigh_height)
      remarks.push_back("the person sits: thighs and lower legs have bones of "
                        "their own");
    if (!person.regions.has_arm[0] || !person.regions.has_arm[1])
      remarks.push_back("an arm could not be told from the trunk, which its "
                        "bones therefore follow; arms that are apart from the "
                        "trunk are found");
    return remarks;
  }


  const PartShape &find_part(const std::vector<PartShape> &parts,
                             const std::string &name)
  {
    for (const PartShape &part : parts)
      if (part.part.name == name)
        return part;
    throw dealii::ExcInternalError();
  }


  /// The surface of a person without the steps of elements or voxels, from
  /// which distances are too small. Surfaces without triangles have none.
  ShapePointer without_steps(const ShapePointer &skin)
  {
    constexpr unsigned int iterations = 10;
    const auto triangles =
      std::dynamic_pointer_cast<const TriangulatedSurface>(skin);
    if (triangles == nullptr)
      return skin;
    return std::make_shared<TriangulatedSurface>(
      smoothed(triangles->mesh(), iterations));
  }


  /// Brings brain and lungs below the surface of a person who stands.
  void fit(Warps &warps,
           OrganFit &organ_fit,
           const ShapeBody &donor,
           const Shape &surface,
           const double scale)
  {
    const auto organ = [&](const std::string &name) {
      const Shape &shape = *find_part(donor.part_shapes(), name).shape;
      const auto box = shape.bounding_box();
      return OrganSurface(shape, 0.045 * std::cbrt(box.volume()));
    };
    const double depth = OrganFit::least_cover / scale;
    const OrganSurface brain = organ("brain"), lungs = organ("lungs");
    SectionWarp &trunk = warps[static_cast<unsigned int>(Region::trunk)];
    trunk = narrowed(trunk, surface, lungs, depth);
    trunk = with_head_inside(trunk, surface, brain, depth);
    organ_fit.brain_cover = brain.least_depth(surface, trunk);
    organ_fit.lung_cover = lungs.least_depth(surface, trunk);
  }


  constexpr double far = 10.; // beyond any person [m]

  /// Part of a shape within a cube of edge 2 far around a place.
  ShapePointer cut(const ShapePointer &shape, const Point<3> &middle)
  {
    return std::make_shared<Intersection>(
      shape, std::make_shared<RoundedBox>(middle, Point<3>(far, far, far)));
  }


  /// Brings the bones of arms and legs into these.
  /// @param knee height of the donor's knees, for who sits [m]
  void fit_limbs(Warps &warps,
                 const ShapeBody &donor,
                 const Shape &surface,
                 const std::optional<double> knee,
                 const double scale)
  {
    constexpr double spacing = 0.007, depth = 0.001;
    for (const unsigned int side : {0, 1})
    {
      const auto warp = [&](const Region left) -> SectionWarp & {
        return warps[static_cast<unsigned int>(left) + side];
      };
      const auto bring_inside = [&](const Region left,
                                    const ShapePointer &bones) {
        warp(left) = with_limb_inside(warp(left),
                                      surface,
                                      OrganSurface(*bones, spacing, 0.),
                                      depth / scale);
      };
      const auto of_side = [&](const std::string &name) {
        return cut(find_part(donor.part_shapes(), name).shape,
                   Point<3>(0., side == 0 ? far : -far, 0.));
      };
      bring_inside(Region::left_arm, of_side("arm bones"));
      const ShapePointer legs = of_side("leg bones");
      if (knee)
      {
        bring_inside(Region::left_leg, cut(legs, {0., 0., *knee - far}));
        bring_inside(Region::left_thigh, cut(legs, {0., 0., *knee + far}));
        continue;
      }
      bring_inside(Region::left_leg, legs);
      warp(Region::left_thigh) = warp(Region::left_leg);
    }
  }


  /// A shape in the regions of both sides of the body, warped.
  ShapePointer warp_sides(const ShapePointer &shape,
                          const SectionWarp &left,
                          const SectionWarp &right)
  {
    return std::make_shared<Union>(std::vector<ShapePointer>{
      std::make_shared<WarpedShape>(cut(shape, {0., far, 0.}), left),
      std::make_shared<WarpedShape>(cut(shape, {0., -far, 0.}), right)});
  }


  /// Bones of the legs of who sits, bent at the knees.
  /// @param knee height of the donor's knees [m]
  ShapePointer
  bend_legs(const ShapePointer &bones, const Warps &warps, const double knee)
  {
    // Both ends reach a little beyond the knee, so that they meet.
    constexpr double overlap = 0.02;
    std::vector<ShapePointer> parts;
    for (const double side : {1., -1.})
    {
      const Region first = side > 0. ? Region::left_thigh : Region::left_leg;
      parts.push_back(
        warp_sides(cut(bones, {0., 0., knee + side * (far - overlap)}),
                   warps[static_cast<unsigned int>(first)],
                   warps[static_cast<unsigned int>(first) + 1]));
    }
    return std::make_shared<Union>(parts);
  }


  std::vector<PartShape> warp_organs(const ShapeBody &donor,
                                     const PersonRegions &donor_regions,
                                     const PersonRegions &person,
                                     const Warps &warps)
  {
    const auto warp = [&](const Region region) {
      return warps[static_cast<unsigned int>(region)];
    };
    std::vector<PartShape> parts;
    for (const PartShape &part : donor.part_shapes())
    {
      if (!is_organ(part.part))
        continue;
      ShapePointer shape;
      if (part.part.name == "arm bones")
        shape = warp_sides(
          part.shape, warp(Region::left_arm), warp(Region::right_arm));
      else if (part.part.name == "leg bones" && person.thigh_height)
        shape = bend_legs(part.shape, warps, donor_regions.knee());
      else if (part.part.name == "leg bones")
        shape = warp_sides(
          part.shape, warp(Region::left_leg), warp(Region::right_leg));
      else
        shape = std::make_shared<WarpedShape>(part.shape, warp(Region::trunk));
      parts.push_back({part.part, shape});
    }
    return parts;
  }


  /// Part of the organs' volume within a surface.
  double part_inside(const std::vector<PartShape> &organs, const Shape &surface)
  {
    std::vector<ShapePointer> shapes;
    for (const PartShape &organ : organs)
      shapes.push_back(organ.shape);
    const Union all(shapes);
    const double height = surface.bounding_box().side_length(2);
    const LabelGrid grid = fill_shape(all, height / 300.);
    double n_all = 0., n_inside = 0.;
    for (unsigned int k = 0; k < grid.size[2]; ++k)
      for (unsigned int j = 0; j < grid.size[1]; ++j)
        for (unsigned int i = 0; i < grid.size[0]; ++i)
          if (grid.at(i, j, k) != LabelGrid::outside)
          {
            n_all += 1.;
            n_inside += surface.value(grid.center(i, j, k)) <= 0. ? 1. : 0.;
          }
    return n_all > 0. ? n_inside / n_all : 1.;
  }


  /// Volume of a part [m^3].
  double volume_of(const std::vector<PartShape> &parts, const std::string &name)
  {
    const Shape &shape = *find_part(parts, name).shape;
    const double spacing = 0.04 * std::cbrt(shape.bounding_box().volume());
    const LabelGrid grid = fill_shape(shape, spacing);
    return grid.volume() *
           (grid.labels.size() - std::count(grid.labels.begin(),
                                            grid.labels.end(),
                                            LabelGrid::outside));
  }


  std::vector<std::string> fit_remarks(const OrganFit &fit,
                                       const std::vector<PartShape> &organs,
                                       const double scale)
  {
    const auto litres = [&](const std::string &name) {
      return brief(1e3 * std::pow(scale, 3) * volume_of(organs, name), 2) +
             " litre";
    };
    const auto verdict = [](const bool holds) {
      return holds ? std::string(": held") : std::string(": NOT HELD");
    };
    const double least = std::min(fit.brain_cover, fit.lung_cover) * scale;
    return {"organs are those of the phantom, warped to this person section by "
            "section; they are not this person's: brain " +
              litres("brain") + ", lungs " + litres("lungs"),
            "check of the organs' volume inside the surface: " +
              brief(100. * fit.inside, 3) + " %, at least " +
              brief(100. * OrganFit::least_inside, 3) + " %" +
              verdict(fit.inside >= OrganFit::least_inside) +
              "; the rest is left out",
            "check of the least tissue over the brain, " +
              brief(1e3 * scale * fit.brain_cover, 3) +
              " mm, and over the lungs, " +
              brief(1e3 * scale * fit.lung_cover, 3) + " mm, at least " +
              brief(1e3 * OrganFit::least_cover) + " mm" +
              verdict(least >= OrganFit::least_cover)};
  }


  /// The region of the voxel that is nearest to a place of the donor.
  Region nearest_region(const PersonRegions &regions, const Point<3> &place)
  {
    const LabelGrid &grid = regions.grid;
    double nearest = std::numeric_limits<double>::max();
    Region region = Region::trunk;
    for (unsigned int k = 0; k < grid.size[2]; ++k)
      for (unsigned int j = 0; j < grid.size[1]; ++j)
        for (unsigned int i = 0; i < grid.size[0]; ++i)
          if (grid.at(i, j, k) != LabelGrid::outside)
          {
            const double square = grid.center(i, j, k).distance_square(place);
            if (square < nearest)
            {
              nearest = square;
              region = static_cast<Region>(grid.at(i, j, k));
            }
          }
    return region;
  }


  /// With which region a place on the skin of the donor goes. Voxels are those
  /// of an arm below the armpit only; what is farther out goes with the arm up
  /// to the shoulder. Thighs are a region of their own for who sits.
  Region region_at(const PersonRegions &regions, const Point<3> &place)
  {
    for (const unsigned int side : {0, 1})
    {
      const double sign = side == 0 ? 1. : -1.;
      if (regions.has_arm[side] &&
          sign * (place[1] - regions.arm_root[side][1]) > 0.)
        return side == 0 ? Region::left_arm : Region::right_arm;
    }
    const Region region = nearest_region(regions, place);
    const bool is_thigh = place[2] > regions.knee();
    return is_thigh && region == Region::left_leg    ? Region::left_thigh
           : is_thigh && region == Region::right_leg ? Region::right_thigh
                                                     : region;
  }
} // namespace


BodyPointer insert_organs(const Body &recipient,
                          const ShapeBody &donor,
                          const OrganInsertion &insertion)
{
  const PosedPerson person = find_person(*recipient.surface(), insertion);
  const Posture &posture = person.posture;
  const Placement to_standing = posture.to_standing();
  const bool stays = posture.is_standing || !insertion.stands_up;
  const Placement back = stays ? posture.from_standing() : Placement();
  const ShapePointer standing =
    PlacedShape::in_own_box(recipient.surface(), to_standing);
  const ShapePointer skin = stays ? recipient.surface() : standing;

  const PersonRegions donor_regions = find_regions(*donor.surface());
  Warps warps = warp_between(donor_regions, person.regions);
  OrganFit organ_fit;
  const PlacedShape smooth(without_steps(recipient.surface()), to_standing);
  fit(warps, organ_fit, donor, smooth, insertion.scale);
  fit_limbs(warps,
            donor,
            smooth,
            person.regions.thigh_height ? std::optional(donor_regions.knee())
                                        : std::nullopt,
            insertion.scale);
  std::vector<PartShape> part_shapes =
    warp_organs(donor, donor_regions, person.regions, warps);
  organ_fit.inside = part_inside(part_shapes, *standing);
  if (1. - organ_fit.inside > insertion.largest_loss)
    throw InputError(
      "Body/Surface/Organs = phantom: " +
      brief(100. * (1. - organ_fit.inside), 3) +
      " % of the organs' volume would be outside of the surface, "
      "Body/Surface/Largest loss of organs allows " +
      brief(100. * insertion.largest_loss, 3) + " %");

  auto remarks = recipient.remarks();
  for (const auto &lines :
       {posture_remarks(person, insertion.stands_up),
        fit_remarks(organ_fit, part_shapes, insertion.scale),
        donor.remarks()})
    remarks.insert(remarks.end(), lines.begin(), lines.end());
  for (PartShape &part_shape : part_shapes)
    part_shape.shape = std::make_shared<PlacedShape>(part_shape.shape, back);
  part_shapes.push_back({recipient.parts()[0], skin});
  const auto body = std::make_shared<ShapeBody>(skin, part_shapes);
  body->set_remarks(remarks);
  body->set_organ_fit(organ_fit);
  std::vector<Landmark> landmarks = donor.landmarks();
  for (Landmark &landmark : landmarks)
  {
    const Region region = region_at(donor_regions, landmark.place);
    landmark.place = skin->project(back.apply(
      warps[static_cast<unsigned int>(region)].apply(landmark.place)));
  }
  body->set_landmarks(landmarks);
  return body;
}
} // namespace contrecoup

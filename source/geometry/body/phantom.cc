// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/phantom.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>

namespace contrecoup
{
using dealii::Point;

namespace
{
  constexpr double reference_stature = 1.756; ///< [m]
  constexpr double mean_density = 990.;       ///< [kg/m^3]

  void append(std::vector<ShapeBody::PartShape> &all,
              const std::vector<ShapeBody::PartShape> &more)
  {
    all.insert(all.end(), more.begin(), more.end());
  }

  /// Volume of a shape from voxels of this size [m^3].
  double volume_of_shape(const ShapePointer &shape, const double spacing)
  {
    LabelGrid grid = make_grid(shape->bounding_box(), spacing);
    ShapeBody(shape, {{{"", Tissue::none}, shape}}).fill(grid);
    return grid.volume() * std::count(grid.labels.begin(),
                                      grid.labels.end(),
                                      static_cast<unsigned char>(0));
  }
} // namespace


void Phantom::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_double(prm,
                 "Stature",
                 "1.756",
                 1.4,
                 2.2,
                 "m",
                 "Height of the standing man, 1.4 to 2.2; the default is "
                 "the 50th percentile.");
  declare_double(prm,
                 "Mass",
                 "78.5",
                 35.,
                 200.,
                 "kg",
                 "Mass of the man, which determines the thickness of flesh; "
                 "the body mass index must be 17 to 40 kg/m^2.");
  declare_double(prm,
                 "Head scale",
                 "1",
                 0.8,
                 1.2,
                 "-",
                 "Size of head and brain relative to the 50th percentile, "
                 "0.8 to 1.2; independent of stature.");
  declare_double(prm,
                 "Skin thickness",
                 "0",
                 0.,
                 0.01,
                 "m",
                 "Thickness of a layer of tissue \"skin\", 0 to 0.01; 0: "
                 "the skin is the surface of the soft tissue.");
}


void Phantom::parse_parameters(dealii::ParameterHandler &prm)
{
  stature_ = read_double(prm, "Stature");
  mass_ = read_double(prm, "Mass");
  head_scale_ = read_double(prm, "Head scale");
  skin_thickness_ = read_double(prm, "Skin thickness");
  const double index = mass_ / (stature_ * stature_);
  if (index < 17. || index > 40.)
    throw InputError("Body/Phantom: a stature of " + brief(stature_) +
                     " m and a mass of " + brief(mass_) +
                     " kg make a body mass index of " + brief(index, 3) +
                     " kg/m^2; it must be 17 to 40, which are " +
                     brief(17. * stature_ * stature_, 3) + " to " +
                     brief(40. * stature_ * stature_, 3) + " kg");
}


double Phantom::find_girth() const
{
  constexpr double spacing = 0.012;
  const double wanted = mass_ / mean_density;
  phantom::Frame frame{stature_ / reference_stature, 1., head_scale_};
  // Below the head, volume is proportional to the square of the girth.
  for (unsigned int step = 0; step < 12; ++step)
  {
    const double ratio =
      wanted / volume_of_shape(phantom::make_flesh(frame), spacing);
    frame.girth *= std::sqrt(ratio);
    if (std::abs(ratio - 1.) < 1e-3)
      break;
  }
  return frame.girth;
}


BodyPointer Phantom::create() const
{
  const phantom::Frame frame{
    stature_ / reference_stature, find_girth(), head_scale_};
  std::vector<ShapeBody::PartShape> part_shapes = phantom::make_nerves(frame);
  append(part_shapes, phantom::make_skeleton(frame));
  append(part_shapes, phantom::make_organs(frame));
  const ShapePointer flesh = phantom::make_flesh(frame);
  if (skin_thickness_ > 0.)
  {
    part_shapes.push_back({{"soft tissue", Tissue::soft_tissue},
                           std::make_shared<Offset>(flesh, -skin_thickness_)});
    part_shapes.push_back({{"skin", Tissue::skin}, flesh});
  }
  else
    part_shapes.push_back({{"soft tissue", Tissue::soft_tissue}, flesh});
  const auto body = std::make_shared<ShapeBody>(flesh, part_shapes);
  body->set_landmarks(phantom::find_landmarks(frame, *flesh));
  return body;
}


std::vector<OrganReference> Phantom::references() const
{
  constexpr double litre = 1e-3;
  const double body = std::pow(stature_ / reference_stature, 3),
               head = std::pow(head_scale_, 3);
  constexpr double skull = 0.75; // of the skeleton's 8.08; follows the head
  const double skeleton = (7.33 * body + skull * head) / (7.33 + skull);
  const auto literature = [](const std::string &source) {
    return "the literature (" + source + ")";
  };
  const auto icrp = [&](const std::string &mass, const double scale) {
    return literature("ICRP 89: " + mass +
                      (scale == 1. ? ""
                                   : " in a man, his volume times " +
                                       brief(scale, 3) + " for the size"));
  };
  return {
    {"whole body",
     {},
     mass_ / mean_density,
     0.02,
     literature("mass over 990 kg/m^3, recalled")},
    {"brain", {"brain"}, 1.40 * litre * head, 0.05, icrp("1.45 kg", head)},
    {"heart",
     {"heart"},
     0.79 * litre * body,
     0.05,
     icrp("0.84 kg with blood", body)},
    {"liver", {"liver"}, 1.70 * litre * body, 0.05, icrp("1.8 kg", body)},
    {"lungs",
     {"lungs"},
     3.3 * litre * body,
     0.05,
     icrp("1.2 kg, half full (recalled)", body)},
    {"skeleton",
     {"skull",
      "spine",
      "ribs",
      "shoulders",
      "arm bones",
      "pelvis",
      "leg bones"},
     8.08 * litre * skeleton,
     0.03,
     icrp("10.5 kg of 1300 kg/m^3", skeleton)}};
}


namespace phantom
{
  Point<3> Frame::at(const double x, const double y, const double z) const
  {
    return Point<3>(height * x, height * y, height * z);
  }

  Point<3> Frame::at_head(const double x, const double y, const double z) const
  {
    // The vertex is 74.5 mm above the centre of the cranium.
    return Point<3>(
      head * x, head * y, reference_stature * height + head * (z - 0.0745));
  }

  ShapePointer make_rod(const Frame &frame,
                        const double side,
                        const std::vector<RodNode> &rod_nodes,
                        const double thickness,
                        const unsigned int n_between)
  {
    std::vector<Sweep::Node> nodes;
    for (const RodNode &rod_node : rod_nodes)
      nodes.push_back({frame.at(rod_node.x, side * rod_node.y, rod_node.z),
                       frame.height * thickness * rod_node.radius});
    return std::make_shared<Sweep>(
      n_between > 0 ? smooth_curve(nodes, n_between) : nodes);
  }

  std::vector<ShapeBody::PartShape> make_nerves(const Frame &frame)
  {
    const Point<3> center = frame.at_head(0., 0., 0.);
    const double h = frame.height;
    // The cord extends to the first lumbar vertebra, its fluid to the sacrum.
    const auto canal = [&](const double z_end, const double radius) {
      std::vector<Sweep::Node> nodes{
        {frame.at_head(-0.012, 0., -0.052), 1.2 * radius * frame.head},
        {frame.at_head(-0.018, 0., -0.09), radius * frame.head}};
      for (const auto &[x, z] : {std::pair<double, double>{-0.045, 1.47},
                                 {-0.072, 1.30},
                                 {-0.066, 1.15},
                                 {-0.055, 1.08},
                                 {-0.037, 1.02},
                                 {-0.050, 0.95}})
        if (z >= z_end)
          nodes.push_back({frame.at(x, 0., z), radius * h});
      return std::make_shared<Sweep>(smooth_curve(nodes, 2));
    };
    const auto brain = std::make_shared<Ellipsoid>(
      center, frame.head * Point<3>(0.084, 0.068, 0.060));
    const auto cranial_fluid = std::make_shared<Ellipsoid>(
      center, frame.head * Point<3>(0.0865, 0.070, 0.0625));
    return {{{"brain", Tissue::brain}, brain},
            {{"spinal cord", Tissue::spinal_cord}, canal(1.07, 0.0055)},
            {{"cerebrospinal fluid", Tissue::cerebrospinal_fluid},
             std::make_shared<Union>(
               std::vector<ShapePointer>{cranial_fluid, canal(0.94, 0.0085)})}};
  }

  std::vector<ShapeBody::PartShape> make_organs(const Frame &frame)
  {
    const double h = frame.height;
    const auto inner_chest = std::make_shared<Ellipsoid>(
      frame.at(0., 0., 1.26), h * Point<3>(0.092, 0.131, 0.222));
    std::vector<ShapePointer> lungs;
    for (const double side : {-1., 1.})
      lungs.push_back(std::make_shared<Intersection>(
        std::make_shared<Ellipsoid>(frame.at(-0.004, side * 0.074, 1.290),
                                    h * Point<3>(0.069, 0.0505, 0.1225)),
        inner_chest));
    return {{{"heart", Tissue::heart},
             std::make_shared<Ellipsoid>(frame.at(0.028, 0.018, 1.255),
                                         h * Point<3>(0.052, 0.052, 0.0696))},
            {{"liver", Tissue::liver},
             std::make_shared<Ellipsoid>(frame.at(0.018, -0.055, 1.122),
                                         h * Point<3>(0.077, 0.092, 0.0605))},
            {{"lungs", Tissue::lung}, std::make_shared<Union>(lungs)}};
  }
} // namespace phantom
} // namespace contrecoup

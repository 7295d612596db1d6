// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/body/phantom.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>

namespace contrecoup
{
namespace phantom
{
  using dealii::Point;

  namespace
  {
    using Shapes = std::vector<ShapePointer>;

    /// A limb through @p rod_nodes on one side of the body.
    ShapePointer make_limb(const Frame &frame,
                           const double side,
                           const std::vector<RodNode> &rod_nodes)
    {
      return make_rod(frame, side, rod_nodes, frame.girth, 1);
    }

    /// A lobe of the trunk, which grows laterally with the girth.
    ShapePointer make_lobe(const Frame &frame,
                           const Point<3> &center,
                           const Point<3> &semi_axes)
    {
      const double wide = frame.height * frame.girth;
      return std::make_shared<Ellipsoid>(
        frame.at(center[0], center[1], center[2]),
        Point<3>(wide * semi_axes[0],
                 wide * semi_axes[1],
                 frame.height * semi_axes[2]));
    }

    ShapePointer make_trunk(const Frame &frame)
    {
      Shapes lobes{make_lobe(frame, {0., 0., 1.27}, {0.116, 0.152, 0.25}),
                   make_lobe(frame, {0.008, 0., 1.06}, {0.110, 0.148, 0.20}),
                   make_lobe(frame, {-0.005, 0., 0.93}, {0.115, 0.165, 0.13}),
                   make_limb(frame,
                             1.,
                             {{-0.015, -0.165, 1.400, 0.062},
                              {-0.020, 0., 1.425, 0.070},
                              {-0.015, 0.165, 1.400, 0.062}})};
      for (const double side : {-1., 1.})
      {
        lobes.push_back(make_lobe(
          frame, {-0.050, side * 0.072, 0.895}, {0.085, 0.085, 0.095}));
        lobes.push_back(make_limb(
          frame,
          side,
          {{-0.025, 0.02, 1.500, 0.045}, {-0.015, 0.14, 1.435, 0.045}}));
      }
      return std::make_shared<Union>(lobes, 0.06 * frame.height);
    }

    ShapePointer make_arm(const Frame &frame, const double side)
    {
      const ShapePointer upper = make_limb(frame,
                                           side,
                                           {{-0.005, 0.185, 1.395, 0.058},
                                            {-0.005, 0.212, 1.250, 0.050},
                                            {-0.010, 0.232, 1.095, 0.041},
                                            {0.000, 0.242, 1.020, 0.043},
                                            {0.015, 0.262, 0.855, 0.027},
                                            {0.018, 0.266, 0.810, 0.022}});
      // Hands do not grow with the girth.
      const double h = frame.height;
      const ShapePointer palm =
        std::make_shared<Ellipsoid>(frame.at(0.022, side * 0.268, 0.775),
                                    h * Point<3>(0.043, 0.017, 0.065));
      const ShapePointer fingers =
        std::make_shared<Ellipsoid>(frame.at(0.024, side * 0.270, 0.715),
                                    h * Point<3>(0.036, 0.013, 0.055));
      const ShapePointer thumb =
        std::make_shared<Sweep>(std::vector<Sweep::Node>{
          {frame.at(0.045, side * 0.262, 0.800), h * 0.014},
          {frame.at(0.070, side * 0.255, 0.745), h * 0.010}});
      return std::make_shared<Union>(Shapes{upper, palm, fingers, thumb},
                                     0.02 * h);
    }

    ShapePointer make_leg(const Frame &frame, const double side)
    {
      const double h = frame.height;
      const ShapePointer leg = make_limb(frame,
                                         side,
                                         {{0.000, 0.092, 0.900, 0.092},
                                          {0.005, 0.096, 0.760, 0.086},
                                          {0.005, 0.101, 0.640, 0.074},
                                          {0.000, 0.105, 0.500, 0.057},
                                          {-0.012, 0.107, 0.370, 0.060},
                                          {-0.014, 0.109, 0.230, 0.045},
                                          {-0.012, 0.110, 0.095, 0.037},
                                          {-0.010, 0.110, 0.060, 0.037}});
      // Feet do not grow with the girth. Their soles are cut at the ground.
      std::vector<Sweep::Node> nodes;
      for (const RodNode &rod_node :
           std::vector<RodNode>{{-0.048, 0.110, 0.030, 0.036},
                                {0.020, 0.112, 0.045, 0.036},
                                {0.080, 0.116, 0.032, 0.037},
                                {0.130, 0.120, 0.020, 0.030},
                                {0.165, 0.122, 0.012, 0.021}})
        nodes.push_back({frame.at(rod_node.x, side * rod_node.y, rod_node.z),
                         h * rod_node.radius});
      const ShapePointer foot = std::make_shared<Sweep>(smooth_curve(nodes, 2));
      return std::make_shared<Union>(Shapes{leg, foot}, 0.03 * h);
    }

    /// The head, which has its own scale, and the neck.
    ShapePointer make_head(const Frame &frame)
    {
      const double s = frame.head;
      const auto node = [&](double x, double y, double z, double radius) {
        return Sweep::Node{frame.at_head(x, y, z), s * radius};
      };
      Shapes lobes{
        std::make_shared<Ellipsoid>(frame.at_head(0., 0., 0.),
                                    s * Point<3>(0.0985, 0.076, 0.0745)),
        std::make_shared<Ellipsoid>(frame.at_head(0.030, 0., -0.075),
                                    s * Point<3>(0.064, 0.060, 0.080)),
        std::make_shared<Sweep>(std::vector<Sweep::Node>{
          node(0.092, 0., -0.030, 0.008), node(0.106, 0., -0.062, 0.012)}),
        std::make_shared<Sweep>(std::vector<Sweep::Node>{
          node(0.060, 0., -0.128, 0.026), node(0.070, 0., -0.135, 0.020)})};
      for (const double side : {-1., 1.})
        lobes.push_back(std::make_shared<Ellipsoid>(
          frame.at_head(-0.008, side * 0.076, -0.030),
          s * Point<3>(0.017, 0.007, 0.030)));
      const ShapePointer head = std::make_shared<Union>(lobes, 0.025 * s);
      // Eye sockets.
      Shapes hollows;
      for (const double side : {-1., 1.})
        hollows.push_back(std::make_shared<Sphere>(
          frame.at_head(0.101, side * 0.033, -0.025), 0.018 * s));
      const ShapePointer face = std::make_shared<Intersection>(
        head, std::make_shared<Union>(hollows), Intersection::With::outside);
      const double wide = frame.height * frame.girth;
      std::vector<Sweep::Node> neck{
        {frame.at(-0.035, 0., 1.43), 0.068 * wide},
        {frame.at(-0.020, 0., 1.50), 0.059 * wide},
        {frame.at_head(-0.010, 0., -0.10), 0.056 * std::min(wide, 1.15 * s)}};
      return std::make_shared<Union>(
        Shapes{face, std::make_shared<Sweep>(smooth_curve(neck, 1))}, 0.03 * s);
    }
  } // namespace

  ShapePointer make_flesh(const Frame &frame)
  {
    Shapes parts{make_trunk(frame), make_head(frame)};
    for (const double side : {-1., 1.})
    {
      parts.push_back(make_arm(frame, side));
      parts.push_back(make_leg(frame, side));
    }
    const ShapePointer whole =
      std::make_shared<Union>(parts, 0.03 * frame.height);
    // Cut between ground and vertex; blends enlarge the bounding box.
    const double vertex = frame.at_head(0., 0., 0.0745)[2];
    const ShapePointer layer = std::make_shared<RoundedBox>(
      Point<3>(0., 0., 0.5 * vertex), Point<3>(10., 10., 0.5 * vertex));
    return std::make_shared<Intersection>(whole, layer);
  }
} // namespace phantom
} // namespace contrecoup

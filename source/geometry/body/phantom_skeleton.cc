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

    /// A bone through @p rod_nodes. @param side 1: left, -1: mirrored to the
    /// right
    ShapePointer make_bone(const Frame &frame,
                           const double side,
                           const std::vector<RodNode> &rod_nodes,
                           const unsigned int n_between = 1)
    {
      return make_rod(frame, side, rod_nodes, 1., n_between);
    }

    /// A bone of the head.
    ShapePointer make_head_bone(const Frame &frame,
                                const std::vector<RodNode> &rod_nodes)
    {
      std::vector<Sweep::Node> nodes;
      for (const RodNode &rod_node : rod_nodes)
        nodes.push_back({frame.at_head(rod_node.x, rod_node.y, rod_node.z),
                         frame.head * rod_node.radius});
      return std::make_shared<Sweep>(smooth_curve(nodes, 2));
    }

    /// A flat bone: a thin ellipsoid, rotated about the vertical axis.
    ShapePointer make_plate(const Frame &frame,
                            const Point<3> &center,
                            const Point<3> &semi_axes,
                            const double angle)
    {
      const Placement placement(
        1., Point<3>(0., 0., angle), frame.at(center[0], center[1], center[2]));
      return std::make_shared<PlacedShape>(
        std::make_shared<Ellipsoid>(Point<3>(), frame.height * semi_axes),
        placement);
    }

    ShapePointer make_skull(const Frame &frame)
    {
      Shapes bones{
        std::make_shared<Ellipsoid>(frame.at_head(0., 0., 0.),
                                    frame.head *
                                      Point<3>(0.094, 0.074, 0.0702)),
        // Cheek bones, upper jaw, lower jaw.
        make_head_bone(frame,
                       {{0.000, -0.062, -0.040, 0.006},
                        {0.045, -0.052, -0.050, 0.012},
                        {0.072, -0.022, -0.058, 0.013},
                        {0.080, 0.000, -0.055, 0.010},
                        {0.072, 0.022, -0.058, 0.013},
                        {0.045, 0.052, -0.050, 0.012},
                        {0.000, 0.062, -0.040, 0.006}}),
        make_head_bone(frame,
                       {{0.025, -0.030, -0.085, 0.011},
                        {0.062, -0.020, -0.088, 0.0145},
                        {0.074, 0.000, -0.088, 0.0125},
                        {0.062, 0.020, -0.088, 0.0145},
                        {0.025, 0.030, -0.085, 0.011}}),
        make_head_bone(frame,
                       {{-0.005, -0.055, -0.055, 0.007},
                        {0.005, -0.050, -0.112, 0.009},
                        {0.050, -0.028, -0.128, 0.0105},
                        {0.066, 0.000, -0.132, 0.0115},
                        {0.050, 0.028, -0.128, 0.0105},
                        {0.005, 0.050, -0.112, 0.009},
                        {-0.005, 0.055, -0.055, 0.007}}),
        // Nose, and the connection of cheeks, jaw and cranium.
        make_head_bone(
          frame, {{0.060, 0., -0.040, 0.014}, {0.066, 0., -0.088, 0.010}}),
        // Base: from the foramen magnum to the nose.
        make_head_bone(frame,
                       {{0.004, 0., -0.070, 0.012},
                        {0.035, 0., -0.062, 0.014},
                        {0.060, 0., -0.040, 0.014}})};
      // Temporal bones: from the pyramid to the mastoid process.
      for (const double side : {-1., 1.})
        bones.push_back(
          make_head_bone(frame,
                         {{0.010, side * 0.016, -0.066, 0.009},
                          {-0.020, side * 0.052, -0.052, 0.011},
                          {-0.016, side * 0.050, -0.074, 0.008}}));
      return std::make_shared<Union>(bones, 0.008 * frame.head);
    }

    /// Vertebral bodies in front of the canal, arches around it, sacrum.
    ShapePointer make_spine(const Frame &frame)
    {
      const double s = frame.head;
      const double h = frame.height;
      const auto with_head = [&](const std::vector<Sweep::Node> &top,
                                 const std::vector<RodNode> &rest) {
        std::vector<Sweep::Node> nodes = top;
        for (const RodNode &rod_node : rest)
          nodes.push_back({frame.at(rod_node.x, rod_node.y, rod_node.z),
                           h * rod_node.radius});
        return std::make_shared<Sweep>(smooth_curve(nodes, 2));
      };
      return std::make_shared<Union>(
        Shapes{with_head({{frame.at_head(0.001, 0., -0.075), 0.012 * s}},
                         {{-0.025, 0., 1.470, 0.013},
                          {-0.048, 0., 1.300, 0.019},
                          {-0.040, 0., 1.150, 0.022},
                          {-0.028, 0., 1.080, 0.025},
                          {-0.009, 0., 1.020, 0.027},
                          {-0.026, 0., 0.955, 0.027}}),
               with_head({{frame.at_head(-0.017, 0., -0.078), 0.014 * s}},
                         {{-0.045, 0., 1.470, 0.015},
                          {-0.073, 0., 1.300, 0.0175},
                          {-0.067, 0., 1.150, 0.019},
                          {-0.056, 0., 1.080, 0.020},
                          {-0.038, 0., 1.020, 0.021},
                          {-0.050, 0., 0.950, 0.018}}),
               make_bone(frame,
                         1.,
                         {{-0.045, 0., 0.965, 0.034},
                          {-0.068, 0., 0.915, 0.027},
                          {-0.075, 0., 0.870, 0.010}})},
        0.006 * h);
    }

    /// One rib, from the spine around the rib cage, descending to the front.
    ShapePointer
    make_rib(const Frame &frame, const double side, const unsigned int number)
    {
      constexpr double radius = 0.0051; // cross-section of 13.5 mm by 7.7 mm
      const double back_height = 1.452 - 0.0275 * (number - 1);
      const double fall = 0.055 + 0.004 * number;
      const double degree = dealii::numbers::PI / 180.;
      const double last =
        degree * (number <= 7 ? 12. : (number <= 10 ? 35. : 100.));
      const double first = 162. * degree;
      constexpr unsigned int n_steps = 14;
      std::vector<Sweep::Node> nodes{
        {frame.at(-0.062, side * 0.012, back_height), frame.height * radius}};
      for (unsigned int step = 0; step <= n_steps; ++step)
      {
        const double angle = first + (last - first) * step / n_steps;
        const double z = back_height - 0.5 * fall * (1. + std::cos(angle));
        const double level = (z - 1.26) / 0.235;
        const double wide = std::sqrt(std::max(0.05, 1. - level * level));
        nodes.push_back({frame.at(0.0965 * wide * std::cos(angle),
                                  side * 0.1345 * wide * std::sin(angle),
                                  z),
                         frame.height * radius});
      }
      return std::make_shared<Sweep>(nodes);
    }

    ShapePointer make_ribs(const Frame &frame)
    {
      Shapes bones;
      for (const double side : {-1., 1.})
        for (unsigned int number = 1; number <= 12; ++number)
          bones.push_back(make_rib(frame, side, number));
      // Breast bone, with the cartilage of ribs 8 to 10.
      for (const double y : {-0.011, 0., 0.011})
        bones.push_back(make_bone(frame,
                                  1.,
                                  {{0.064, y, 1.405, 0.009},
                                   {0.088, y, 1.320, 0.008},
                                   {0.096, y, 1.230, 0.007}}));
      for (const double side : {-1., 1.})
        bones.push_back(make_bone(frame,
                                  side,
                                  {{0.096, 0.008, 1.225, 0.007},
                                   {0.088, 0.050, 1.180, 0.007},
                                   {0.070, 0.080, 1.130, 0.007}}));
      return std::make_shared<Union>(bones);
    }

    ShapePointer make_shoulders(const Frame &frame)
    {
      constexpr double eighth_turn = dealii::numbers::PI / 4.;
      Shapes bones;
      for (const double side : {-1., 1.})
      {
        // Collar bone, shoulder blade with its spine, socket.
        bones.push_back(make_bone(frame,
                                  side,
                                  {{0.062, 0.020, 1.412, 0.009},
                                   {0.045, 0.090, 1.430, 0.007},
                                   {0.000, 0.170, 1.432, 0.008}}));
        bones.push_back(make_plate(frame,
                                   {-0.068, side * 0.104, 1.335},
                                   {0.007, 0.052, 0.075},
                                   -side * eighth_turn));
        bones.push_back(make_bone(frame,
                                  side,
                                  {{-0.085, 0.075, 1.375, 0.006},
                                   {-0.050, 0.140, 1.415, 0.008},
                                   {-0.010, 0.178, 1.432, 0.008}}));
        bones.push_back(make_bone(
          frame,
          side,
          {{-0.045, 0.125, 1.375, 0.010}, {-0.018, 0.155, 1.395, 0.015}}));
      }
      return std::make_shared<Union>(bones, 0.006 * frame.height);
    }

    ShapePointer make_arm_bones(const Frame &frame)
    {
      Shapes bones;
      for (const double side : {-1., 1.})
      {
        bones.push_back(make_bone(frame,
                                  side,
                                  {{-0.006, 0.180, 1.398, 0.025},
                                   {-0.004, 0.192, 1.350, 0.014},
                                   {-0.005, 0.213, 1.230, 0.012},
                                   {-0.010, 0.228, 1.130, 0.0125},
                                   {-0.010, 0.231, 1.105, 0.021}}));
        bones.push_back(make_bone(
          frame,
          side,
          {{-0.010, 0.217, 1.105, 0.013}, {-0.010, 0.247, 1.105, 0.013}}));
        bones.push_back(make_bone(frame,
                                  side,
                                  {{-0.020, 0.229, 1.100, 0.013},
                                   {-0.008, 0.231, 1.030, 0.009},
                                   {0.008, 0.253, 0.860, 0.0075}}));
        bones.push_back(make_bone(frame,
                                  side,
                                  {{0.002, 0.242, 1.080, 0.010},
                                   {0.008, 0.252, 0.980, 0.008},
                                   {0.020, 0.268, 0.860, 0.013}}));
        bones.push_back(make_bone(
          frame,
          side,
          {{0.012, 0.263, 0.845, 0.013}, {0.024, 0.266, 0.832, 0.013}}));
        bones.push_back(make_bone(frame,
                                  side,
                                  {{0.030, 0.264, 0.830, 0.007},
                                   {0.047, 0.262, 0.797, 0.006},
                                   {0.068, 0.2555, 0.750, 0.005}}));
        for (const double x : {-0.008, 0.012, 0.032, 0.050})
          bones.push_back(
            make_bone(frame,
                      side,
                      {{0.018 + 0.3 * (x - 0.02), 0.266, 0.83, 0.006},
                       {x, 0.268, 0.770, 0.0055},
                       {0.024 + 0.8 * (x - 0.02), 0.270, 0.690, 0.0045}}));
      }
      return std::make_shared<Union>(bones, 0.004 * frame.height);
    }

    ShapePointer make_pelvis(const Frame &frame)
    {
      constexpr double turn = dealii::numbers::PI / 5.;
      Shapes bones;
      for (const double side : {-1., 1.})
      {
        // Wing of the ilium, sacroiliac joint, hip socket.
        bones.push_back(make_plate(frame,
                                   {-0.010, side * 0.095, 0.985},
                                   {0.070, 0.012, 0.064},
                                   side * turn));
        bones.push_back(make_bone(
          frame,
          side,
          {{-0.055, 0.030, 0.960, 0.018}, {-0.045, 0.065, 0.965, 0.014}}));
        bones.push_back(make_bone(
          frame,
          side,
          {{-0.010, 0.088, 0.945, 0.016}, {-0.004, 0.083, 0.908, 0.033}}));
        // Pubis, ischium, and the ramus between them.
        bones.push_back(make_bone(frame,
                                  side,
                                  {{0.005, 0.075, 0.900, 0.014},
                                   {0.040, 0.040, 0.885, 0.010},
                                   {0.052, 0.004, 0.870, 0.012}}));
        bones.push_back(make_bone(frame,
                                  side,
                                  {{-0.010, 0.080, 0.895, 0.018},
                                   {-0.028, 0.065, 0.840, 0.018},
                                   {0.010, 0.045, 0.838, 0.010},
                                   {0.045, 0.012, 0.862, 0.009}}));
      }
      return std::make_shared<Union>(bones, 0.01 * frame.height);
    }

    /// Thigh, knee cap, lower leg, foot.
    Shapes make_leg_bones(const Frame &frame, const double side)
    {
      Shapes bones{
        make_bone(
          frame,
          side,
          {{-0.004, 0.088, 0.905, 0.024}, {-0.004, 0.105, 0.895, 0.016}}),
        make_bone(
          frame,
          side,
          {{-0.004, 0.100, 0.898, 0.015}, {-0.006, 0.138, 0.865, 0.019}}),
        make_bone(frame,
                  side,
                  {{-0.005, 0.138, 0.880, 0.019},
                   {0.002, 0.130, 0.820, 0.018},
                   {0.006, 0.115, 0.680, 0.015},
                   {0.002, 0.106, 0.560, 0.021},
                   {0.000, 0.105, 0.515, 0.027}}),
        make_bone(
          frame,
          side,
          {{-0.004, 0.082, 0.500, 0.027}, {-0.004, 0.128, 0.500, 0.027}}),
        make_bone(frame,
                  side,
                  {{0.038, 0.105, 0.512, 0.013}, {0.038, 0.105, 0.498, 0.013}}),
        make_bone(frame,
                  side,
                  {{0.000, 0.085, 0.460, 0.022}, {0.000, 0.125, 0.460, 0.022}}),
        make_bone(frame,
                  side,
                  {{0.002, 0.105, 0.455, 0.026},
                   {0.004, 0.105, 0.400, 0.0205},
                   {0.000, 0.106, 0.250, 0.0145},
                   {-0.010, 0.106, 0.110, 0.018},
                   {-0.011, 0.105, 0.085, 0.020}}),
        make_bone(frame,
                  side,
                  {{-0.016, 0.132, 0.445, 0.010},
                   {-0.018, 0.131, 0.250, 0.0075},
                   {-0.016, 0.130, 0.080, 0.010}}),
        make_bone(
          frame,
          side,
          {{-0.006, 0.110, 0.062, 0.021}, {-0.050, 0.110, 0.032, 0.023}})};
      for (const double y : {0.098, 0.110, 0.122, 0.132})
        bones.push_back(make_bone(frame,
                                  side,
                                  {{0.010, 0.6 * y + 0.044, 0.050, 0.0135},
                                   {0.075, y, 0.030, 0.009},
                                   {0.155, y + 0.004, 0.014, 0.006}}));
      return bones;
    }
  } // namespace

  std::vector<ShapeBody::PartShape> make_skeleton(const Frame &frame)
  {
    Shapes legs;
    for (const double side : {-1., 1.})
      for (const ShapePointer &bone : make_leg_bones(frame, side))
        legs.push_back(bone);
    return {{{"skull", Tissue::skeleton}, make_skull(frame)},
            {{"spine", Tissue::skeleton}, make_spine(frame)},
            {{"ribs", Tissue::skeleton}, make_ribs(frame)},
            {{"shoulders", Tissue::skeleton}, make_shoulders(frame)},
            {{"arm bones", Tissue::skeleton}, make_arm_bones(frame)},
            {{"pelvis", Tissue::skeleton}, make_pelvis(frame)},
            {{"leg bones", Tissue::skeleton},
             std::make_shared<Union>(legs, 0.005 * frame.height)}};
  }
} // namespace phantom
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/body/phantom.h>

namespace contrecoup
{
namespace phantom
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /// First intersection of a line from outside with a shape. Steps do not
    /// exceed the distance, so none jumps over the surface.
    Point<3> find_entry(const Shape &shape,
                        const Point<3> &begin,
                        const Tensor<1, 3> &direction)
    {
      constexpr unsigned int most_steps = 2000;
      constexpr double near = 1e-7;
      Point<3> point = begin;
      for (unsigned int step = 0; step < most_steps; ++step)
      {
        const double value = shape.value(point);
        if (value < near)
          break;
        point += value * direction;
      }
      return shape.project(point);
    }


    /// A ray towards a landmark: a point on the ray, and the direction from
    /// which it comes.
    struct Aim
    {
      const char *name;
      double x, y, z; ///< [m]
      unsigned int axis;
      double side; ///< sign of the axis from which the ray comes
    };


    Landmark find_landmark(const Aim &aim,
                           const std::string &prefix,
                           Point<3> point,
                           const Shape &skin)
    {
      constexpr double far = 0.7;
      Tensor<1, 3> direction;
      direction[aim.axis] = -aim.side;
      return {prefix + aim.name,
              find_entry(skin, point - far * direction, direction)};
    }
  } // namespace


  std::vector<Landmark> find_landmarks(const Frame &frame, const Shape &skin)
  {
    std::vector<Landmark> landmarks;
    for (const Aim &aim : {Aim{"forehead", 0., 0., 0.025, 0, 1.},
                           Aim{"vertex", 0., 0., 0., 2, 1.},
                           Aim{"occiput", 0., 0., 0., 0, -1.}})
      landmarks.push_back(
        find_landmark(aim, "", frame.at_head(aim.x, aim.y, aim.z), skin));
    for (const Aim &aim : {Aim{"throat", 0., 0., 1.49, 0, 1.},
                           Aim{"chest", 0., 0., 1.30, 0, 1.},
                           Aim{"abdomen", 0., 0., 1.08, 0, 1.},
                           Aim{"back", 0., 0., 1.25, 0, -1.}})
      landmarks.push_back(
        find_landmark(aim, "", frame.at(aim.x, aim.y, aim.z), skin));
    for (const double side : {1., -1.})
    {
      const std::string prefix = side > 0. ? "left " : "right ";
      for (const Aim &aim : {Aim{"eye", 0., 0.033, -0.025, 0, 1.},
                             Aim{"temple", 0.045, 0., 0., 1, side},
                             Aim{"ear", -0.008, 0., -0.030, 1, side}})
        landmarks.push_back(find_landmark(
          aim, prefix, frame.at_head(aim.x, side * aim.y, aim.z), skin));
      for (const Aim &aim : {Aim{"upper arm", 0., 0., 1.30, 1, side},
                             Aim{"thigh", 0., 0.098, 0.70, 0, 1.},
                             Aim{"shin", 0., 0.108, 0.30, 0, 1.},
                             Aim{"calf", 0., 0.108, 0.33, 0, -1.}})
        landmarks.push_back(find_landmark(
          aim, prefix, frame.at(aim.x, side * aim.y, aim.z), skin));
    }
    return landmarks;
  }
} // namespace phantom
} // namespace contrecoup

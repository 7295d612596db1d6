// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/scene/person.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::coupling
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double degree = boost::math::double_constants::degree; // [rad]

  /// Place of a landmark; nothing without one of that name.
  std::optional<Point<3>> find_landmark(const Body &body,
                                        const std::string &name)
  {
    for (const Landmark &landmark : body.landmarks())
      if (landmark.name == name)
        return landmark.place;
    return {};
  }


  /// Axes of a person whose posture a file gives, from the landmarks.
  std::optional<PersonAxes> axes_by_landmarks(const Body &body)
  {
    const auto chest = find_landmark(body, "chest");
    const auto back = find_landmark(body, "back");
    const auto left = find_landmark(body, "left ear");
    const auto right = find_landmark(body, "right ear");
    if (!chest || !back || !left || !right)
      return {};
    PersonAxes axes;
    axes.left = *left - *right;
    axes.left /= axes.left.norm();
    // From the middle of the trunk to that of the head.
    axes.up = 0.5 * ((*left - *chest) + (*right - *back));
    axes.up -= (axes.up * axes.left) * axes.left;
    axes.up /= axes.up.norm();
    axes.forward = cross_product_3d(axes.left, axes.up);
    return axes;
  }


  /// Whether the knees are bent: from shin to thigh it is not straight up.
  bool are_legs_bent(const Body &body, const Tensor<1, 3> &up)
  {
    const auto shin = find_landmark(body, "left shin");
    const auto thigh = find_landmark(body, "left thigh");
    return shin && thigh &&
           (*thigh - *shin) * up < 0.85 * thigh->distance(*shin);
  }


  /// Axes of phantom and images, which face +x before they are rotated; of
  /// surfaces, those of their file.
  PersonAxes axes_by_rotation(const Tensor<1, 3> &angles)
  {
    const Placement rotation(1., angles, Tensor<1, 3>());
    const auto axis = [&](const unsigned int d) {
      Tensor<1, 3> direction;
      direction[d] = 1.;
      return rotation.rotate(direction);
    };
    return {axis(0), axis(1), axis(2)};
  }


  /// Puts a person upright along that axis of @p file which is nearly the
  /// person's own: a head that is held forward inclines the landmarks' axis.
  void straighten(PersonAxes &axes, const PersonAxes &file)
  {
    constexpr double nearly = 0.97; // 14 degrees
    for (const Tensor<1, 3> &axis : {file.forward, file.left, file.up})
      if (std::abs(axes.up * axis) > nearly)
        axes.up = std::copysign(1., axes.up * axis) * axis;
    axes.left -= (axes.left * axes.up) * axes.up;
    axes.left /= axes.left.norm();
    axes.forward = cross_product_3d(axes.left, axes.up);
  }
} // namespace


Person::Person(dealii::ParameterHandler &prm,
               const Body &body,
               const double mass,
               const Point<3> &charge)
  : kind_(prm.get("Kind"))
  , mass_(mass)
{
  if (kind_ == "surface")
  {
    axes_ = axes_by_landmarks(body);
    is_seated_ = axes_ && are_legs_bent(body, axes_->up);
    if (axes_)
      straighten(*axes_, axes_by_rotation(Placement::read_rotation(prm)));
  }
  else if (kind_ == "phantom" || kind_ == "image")
    axes_ = axes_by_rotation(Placement::read_rotation(prm));
  const ShapePointer surface = body.surface();
  const Tensor<1, 3> vertical = Point<3>::unit_vector(2),
                     up = axes_ ? axes_->up : vertical;
  const double top = surface->reach(up), bottom = -surface->reach(-up);
  length_ = is_seated_ ? surface->reach(vertical) + surface->reach(-vertical)
                       : top - bottom;
  const Tensor<1, 3> height = charge - Point<3>(),
                     from_middle = charge - surface->bounding_box().center();
  to_charge_ =
    from_middle + ((height - from_middle) * up - 0.5 * (top + bottom)) * up;
  beyond_ = height * up - std::clamp(height * up, bottom, top);
  if (kind_ == "phantom")
  {
    length_ = read_double(prm, "Scale");
    const Section section(prm, "Phantom");
    length_ *= read_double(prm, "Stature");
  }
}


std::string Person::posture() const
{
  constexpr double nearly = 0.9;
  if (!axes_)
    return "";
  const double upright = axes_->up[2];
  if (upright > nearly)
    return is_seated_ ? "seated" : "standing";
  if (upright < -nearly)
    return "upside down";
  return std::abs(upright) < 0.3 ? "lying" : "inclined";
}


std::string Person::description() const
{
  const std::string length = brief(length_, 4), mass = brief(mass_, 3);
  const std::string size = " of " + length + " m and " + mass + " kg";
  if (kind_ == "image")
    return "a body of medical images" + size;
  // A length that is no stature is called a height.
  const std::string height = " of " + mass + " kg, " + length + " m high";
  if (!axes_)
    return "a " + kind_ + height;
  const std::string posture_name = posture();
  return std::string(posture_name == "inclined" ? "an " : "a ") +
         (posture_name == "upside down" ? "person upside down"
                                        : posture_name + " person") +
         (is_seated_ ? height : size);
}


double Person::charge_azimuth() const
{
  if (!axes_)
    return std::numeric_limits<double>::quiet_NaN();
  return std::atan2(to_charge_ * axes_->left, to_charge_ * axes_->forward) /
         degree;
}


double Person::charge_elevation() const
{
  if (!axes_)
    return std::numeric_limits<double>::quiet_NaN();
  const double sine = to_charge_ * axes_->up / to_charge_.norm();
  return std::asin(std::clamp(sine, -1., 1.)) / degree;
}


std::string Person::side_to_charge() const
{
  constexpr double steep = 60., oblique = 45., behind = 135.; // [degrees]
  if (!axes_)
    return "";
  const double azimuth = charge_azimuth();
  const double beside =
    (to_charge_ - (to_charge_ * axes_->up) * axes_->up).norm();
  if (std::abs(beyond_) > std::tan(steep * degree) * beside)
    return beyond_ > 0. ? "head" : "feet";
  if (std::abs(azimuth) <= oblique)
    return "front";
  if (std::abs(azimuth) >= behind)
    return "back";
  return azimuth > 0. ? "left side" : "right side";
}


std::string Person::charge_in_words() const
{
  const std::string side = side_to_charge();
  const std::string front =
    kind_ == "image" ? " (the front of the image, +y of its header)" : "";
  // An angle about the body's long axis says nothing along this axis.
  if (side.empty() || side == "head" || side == "feet")
    return side.empty() ? "" : "beyond the person's " + side;
  const double azimuth = std::round(charge_azimuth());
  if (azimuth == 0. || std::abs(azimuth) == 180.)
    return (posture() == "lying" ? "straight before the person's " + side
            : azimuth == 0.      ? "straight ahead of the person"
                                 : "straight behind the person") +
           front;
  return brief(std::abs(azimuth)) +
         (std::abs(azimuth) == 1. ? " degree" : " degrees") + " to the " +
         (azimuth < 0. ? "right" : "left") + " of where the person faces" +
         front;
}
} // namespace contrecoup::coupling

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <string>

namespace contrecoup::coupling
{
/// Axes of a person, orthonormal: where front, left side and head point to.
struct PersonAxes
{
  dealii::Tensor<1, 3> forward, left, up;
};


/// Who is in a scene and how the person is turned towards the charge.
class Person
{
public:
  /**
   * @param prm entries of the scene, in its section "Body"
   * @param body the same body
   * @param mass of the body [kg]
   * @param charge centre of the charge [m]
   */
  Person(dealii::ParameterHandler &prm,
         const Body &body,
         double mass,
         const dealii::Point<3> &charge);

  /// The body in words: "a standing person of 1.756 m and 78.5 kg"; the kind of
  /// body where it is not known to be a person.
  std::string description() const;

  /// Axes of phantom, images, and surfaces with landmarks; those of other
  /// bodies are not known.
  const std::optional<PersonAxes> &axes() const
  {
    return axes_;
  }

  /// standing, seated, lying, upside down, or inclined; empty without axes.
  std::string posture() const;

  /// Side that is turned to the charge, as the person would name it: front,
  /// left side, back, right side, head, feet; empty without axes.
  std::string side_to_charge() const;

  /// Where the charge is, seen by the person, as in "beyond the person's head";
  /// "" of what is no person.
  std::string charge_in_words() const;

  /// Direction of the charge from the person's front towards the left, about
  /// the person's own upright axis [degrees]; NaN without axes.
  double charge_azimuth() const;

  /// Direction of the charge above the plane that is normal to that axis, from
  /// the middle between soles and vertex [degrees]; NaN without axes.
  double charge_elevation() const;

  /// Stature of the phantom, else extent of the body along the upright axis;
  /// its height, as it is turned, of who sits and without axes [m].
  double length() const
  {
    return length_;
  }

  double mass() const
  {
    return mass_;
  }

private:
  std::string kind_;
  std::optional<PersonAxes> axes_;
  bool is_seated_ = false;
  dealii::Tensor<1, 3> to_charge_; ///< from the middle of the body [m]
  double
    beyond_; ///< of the charge above the vertex, or below the soles < 0 [m]
  double length_;
  double mass_;
};
} // namespace contrecoup::coupling

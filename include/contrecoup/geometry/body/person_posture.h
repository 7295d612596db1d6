// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/person_regions.h>
#include <contrecoup/geometry/shape/placement.h>
#include <contrecoup/geometry/shape/shape.h>

#include <optional>
#include <string>

namespace contrecoup
{
/// How a person stands or lies, and which way the person faces.
struct Posture
{
  dealii::Tensor<1, 3> up;      ///< unit vector from the feet to the head
  dealii::Tensor<1, 3> forward; ///< unit vector to where the person faces
  bool is_standing = true;      ///< whether up is z
  bool face_agrees = true;      ///< whether the face points where the feet do

  /// Rotation after which the person stands along z and faces +x.
  Placement to_standing() const;

  /// Inverse of to_standing().
  Placement from_standing() const;

  /// Angles of to_standing(), as Placement takes them [degrees].
  dealii::Tensor<1, 3> angles() const;

  /// Angle of forward from +x about z, from -180 to 180 [degrees].
  double facing() const;
};

/// A person with posture and, after Posture::to_standing(), regions.
struct PosedPerson
{
  Posture posture;
  PersonRegions regions;
};

/**
 * Finds the posture of a whole person of any size.
 *
 * The longest axis of inertia is the body's; it is vertical unless it is
 * inclined by more than 45 degrees. The head is at the end at which
 * find_regions() finds neck and head. The widest direction of the trunk is
 * lateral, and feet point forward of the ankles.
 * @param facing angle from +x about z of a standing person, if it is known
 * [degrees]
 * @param neck_height of the neck above the soles, if it is known [m]
 * @throws InputError for what is not one whole person, and where feet and trunk
 * do not agree
 */
PosedPerson find_posture(const Shape &surface,
                         std::optional<double> facing,
                         std::optional<double> neck_height = {});

/// A direction as text: +x, or its components.
std::string direction_name(const dealii::Tensor<1, 3> &direction);
} // namespace contrecoup

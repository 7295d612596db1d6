// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>

#include <optional>

namespace contrecoup
{
/// How organs are inserted into a person.
struct OrganInsertion
{
  /// Fraction of the organs' volume that may be outside the person [-].
  double largest_loss = 0.1;
  /// Angle of the person's front from +x about z, if it is known [degrees].
  std::optional<double> facing;
  /// Height of the person's neck above the soles, if it is known [m].
  std::optional<double> neck_height;
  /// Whether a person who lies is stood up along z, facing +x.
  bool stands_up = true;
  /// Later scale of the person, for thicknesses in m [-].
  double scale = 1.;
};

/**
 * Returns @p recipient with the organs of @p donor. Posture and regions of the
 * recipient are found (find_posture(), find_regions()), and the organs of each
 * region of the donor are warped to that of the recipient, section by section
 * (warp_between()). Trunk and head are then narrowed where lungs or brain would
 * have less than OrganFit::least_cover of tissue over them. Every part of the
 * donor except skin and soft tissue replaces the recipient's tissue, where it
 * is inside the recipient. Landmarks are warped and projected onto the surface.
 *
 * Remarks state posture and fit; the body has an organ_fit().
 * @param recipient a body of one part; stood up if it lies
 * @param donor the phantom: a standing man who faces +x, whose parts "arm
 * bones" and "leg bones" are those of the limbs
 * @throws InputError for what is not one whole person, and when more than the
 * largest loss of the organs' volume is outside
 */
BodyPointer insert_organs(const Body &recipient,
                          const ShapeBody &donor,
                          const OrganInsertion &insertion);
} // namespace contrecoup

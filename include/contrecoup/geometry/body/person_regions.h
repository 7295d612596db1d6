// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/image/label_grid.h>
#include <contrecoup/geometry/shape/shape.h>

#include <array>
#include <optional>
#include <vector>

namespace contrecoup
{
/// Regions of a person; labels of the voxels in PersonRegions.
enum class Region : unsigned char
{
  trunk, ///< with neck and head
  left_arm,
  right_arm,
  left_leg, ///< of who sits, below the thighs
  right_leg,
  left_thigh, ///< of who sits
  right_thigh
};

constexpr unsigned int n_regions = 7;

/// Voxels of an upright person who faces +x, by region.
struct PersonRegions
{
  LabelGrid grid; ///< labels are numbers of Region, or LabelGrid::outside

  /// Heights, as layers of the grid: the lowest layer of the body, the first
  /// in which the legs are one (that of the seat of who sits), that of the
  /// least section of the neck, and the one above the vertex.
  unsigned int sole = 0, crotch = 0, neck = 0, vertex = 0;

  /// Height of the middle of a seated person's thighs at the knees [m].
  std::optional<double> thigh_height;

  /// Whether the left and the right arm were told from the trunk, also at the
  /// hand, and the centres of their highest known voxels next to the trunk and
  /// of those at the tip, or nearest to a hand that touches the trunk [m].
  std::array<bool, 2> has_arm{{false, false}}, has_hand{{false, false}};
  std::array<dealii::Point<3>, 2> arm_root, arm_tip;

  /// Height when standing; of who sits by that of trunk and head [m].
  double stature() const;

  /// Height of the knees of who stands [m].
  double knee() const;

  bool is(const std::size_t voxel, const Region region) const
  {
    return grid.labels[voxel] == static_cast<unsigned char>(region);
  }
};

/**
 * Divides a standing or seated person into regions. Legs are followed upwards,
 * layer by layer, until they are one; trunk and head from there to the vertex.
 * Thighs that reach far to the front where the legs join are those of who sits:
 * what is before the trunk there. An arm
 * is what is farthest from the axis of trunk and head on paths within the
 * body, up to where its section grows to that of the trunk (geodesic extrema:
 * Plagemann, Ganapathi, Koller and Thrun 2010). An arm whose hand touches the
 * body is what is next to the trunk.
 * @param surface upright along z; which of both sides faces +x does not matter
 * @param neck_height of the neck above the soles, if it is known [m]
 * @throws InputError that says what is missing or too many, and which section
 * was looked at: for what is not one piece, has not two legs and ankles, or no
 * neck and head
 */
PersonRegions find_regions(const Shape &surface,
                           std::optional<double> neck_height = {});
} // namespace contrecoup

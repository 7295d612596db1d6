// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/shape/section_warp.h>

#include <cstdint>
#include <vector>

namespace contrecoup
{
/// Points on the surface of an organ. The depth of each is the mean over the
/// patch of those around it, so that steps and dents of a person's surface that
/// are smaller than a patch do not count.
class OrganSurface
{
public:
  /// Points about this distance apart [m]; patches of the given radius, which
  /// are to be wider than elements of which a surface may consist [m].
  OrganSurface(const Shape &organ, double spacing, double patch = 0.015);

  const std::vector<dealii::Point<3>> &points() const
  {
    return points_;
  }

  /// Depths of the patches below a surface after a warp has carried them [m].
  std::vector<double> depths(const Shape &surface,
                             const SectionWarp &warp) const;

  /// The least of them [m].
  double least_depth(const Shape &surface, const SectionWarp &warp) const;

private:
  std::vector<dealii::Point<3>> points_;
  std::vector<std::vector<std::uint32_t>> patches_; ///< by point
};

/**
 * Narrows sections of a warp around their centres where an organ that it
 * carries would be less than @p depth below a surface [m].
 */
SectionWarp narrowed(const SectionWarp &warp,
                     const Shape &surface,
                     const OrganSurface &organ,
                     double depth);

/**
 * The same of a limb, whose sections are moved to where the organ is deep
 * enough before they are narrowed, but for the first and the last one, its
 * joints.
 */
SectionWarp with_limb_inside(const SectionWarp &warp,
                             const Shape &surface,
                             const OrganSurface &organ,
                             double depth);

/**
 * Moves and then shrinks the head, which the last two sections of a warp hold,
 * until an organ in it is at least @p depth below a surface [m].
 */
SectionWarp with_head_inside(const SectionWarp &warp,
                             const Shape &surface,
                             const OrganSurface &organ,
                             double depth);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/person_regions.h>
#include <contrecoup/geometry/shape/section_warp.h>

#include <vector>

namespace contrecoup
{
/// One section of a limb, measured.
struct LimbSection
{
  double station = 0.;         ///< along the limb [m]
  double center[2] = {0., 0.}; ///< of its area, across [m]
  double spread[2] = {0., 0.}; ///< rms distances from the centre [m]
  double turn = 0.;            ///< of the directions of the spreads [rad]
};

/// A limb by its sections, in the order of their stations.
struct Limb
{
  SectionFrame frame;
  std::vector<LimbSection> sections;
};

/**
 * The warp of each region from a standing person to another one, by sections at
 * places that correspond to each other: legs from the soles to where they join
 * (of who sits, lower legs to the knees and thighs from there to the hips), the
 * trunk from there to the neck and to both ends of the cranium, arms from the
 * trunk to their tips. Hands and feet have the directions of their largest
 * width, which turns gradually towards them. An arm that either of them lacks
 * follows the trunk, scaled as that is at the shoulders.
 */
std::array<SectionWarp, n_regions> warp_between(const PersonRegions &from,
                                                const PersonRegions &to);
} // namespace contrecoup

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
 * The warp of each region from a standing person to one who stands or sits, by
 * sections at places that correspond to each other: legs from the soles to
 * where they join (of a seated person, lower legs to the knees and thighs from
 * there to the hips), the trunk from there to the neck and to both ends of the
 * cranium, arms from the trunk to their tips. Hands and feet are turned to
 * their widest direction; the turn grows gradually along forearm and shin. If
 * either person lacks an arm, its warp is that of the trunk.
 */
std::array<SectionWarp, n_regions> warp_between(const PersonRegions &from,
                                                const PersonRegions &to);
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/contact_planes.h>
#include <contrecoup/ale/mesh/mesh_description.h>
#include <contrecoup/ale/mesh/region_descriptions.h>
#include <contrecoup/numerics/shell_impact.h>

#include <optional>

namespace contrecoup::ale
{
/// What the description of a layered head tells before a run.
struct HeadEstimate
{
  double mass = 0.;       ///< of the whole head [kg]
  double scalp_mass = 0.; ///< that 5 mm of scalp around it would have [kg]
  bool has_scalp = false;
  double liquid_radius = 0.; ///< within the skull [m]
  /// The head as a shell full of liquid, if its skull is solid and runs onto a
  /// plane; for ellipsoids with the radius of the sphere of the same volume.
  std::optional<ShellImpact> impact;
};

/// @return nothing for other meshes, and for heads whose nodes are moved
std::optional<HeadEstimate> estimate_head(const MeshDescription &mesh,
                                          const RegionDescriptions &regions,
                                          const ContactPlanes &planes);
} // namespace contrecoup::ale

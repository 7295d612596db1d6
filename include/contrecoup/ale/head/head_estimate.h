// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/contact_planes.h>
#include <contrecoup/ale/mesh/mesh_description.h>
#include <contrecoup/ale/mesh/region_descriptions.h>
#include <contrecoup/numerics/exact/shell_impact.h>

#include <optional>

namespace contrecoup::ale
{
/// Estimates for a layered head from its description, before a run.
struct HeadEstimate
{
  double mass = 0.;       ///< of the whole head [kg]
  double scalp_mass = 0.; ///< of 5 mm of scalp around the head [kg]
  bool has_scalp = false;
  double liquid_radius = 0.;  ///< of the liquid inside the skull [m]
  double contact_begins = 0.; ///< time of the first contact with a plane [s]
  /// Impact of a liquid-filled shell, if the skull is solid and hits a plane;
  /// an ellipsoid counts as the sphere of equal volume.
  std::optional<ShellImpact> impact;
};

/// Returns nothing for other meshes and for heads with moved nodes.
std::optional<HeadEstimate> estimate_head(const MeshDescription &mesh,
                                          const RegionDescriptions &regions,
                                          const ContactPlanes &planes);
} // namespace contrecoup::ale

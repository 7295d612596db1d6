// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/rigid_body.h>

#include <cstddef>
#include <string>
#include <vector>

namespace contrecoup::gas
{
/// Warning of parts of a body that may lie between the corners of all cells, so
/// that the gas does not have them: those that are thinner than the diagonal of
/// a cell. Empty without any.
/// @param places on the surface of the body, whose names the warning has
/// @param diagonal of a cell at the body [m]
std::string warn_of_thin_parts(const RigidBody &body,
                               const std::vector<Landmark> &places,
                               double diagonal);

/// Facets that a gauge reads.
struct GaugePatch
{
  std::string name;
  std::vector<std::size_t> facets;
  double distance = 0.; ///< of the nearest facet of its side [m]
};

/// Warnings of gauges at which the gas has no skin, since no facet is within
/// the diagonal of a cell, and of those that read the same facets.
std::vector<std::string> warn_of_patches(const std::vector<GaugePatch> &patches,
                                         double diagonal);
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/rigid_body.h>

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
} // namespace contrecoup::gas

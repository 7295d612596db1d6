// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>

namespace contrecoup::gas
{
/**
 * Requires that each entry that selects gas or body by position selects some:
 * regions of the initial state, fine box and size limits of the adaptation,
 * finer regions of the body. Warns of size limits that begin after the run.
 * Checks box domains only.
 *
 * @param prm with all entries
 * @param body may be empty
 * @throws InputError for the first entry that selects nothing
 */
template <int dim>
void check_selections(ParameterHandler &prm,
                      const CoarseMesh<dim> &mesh,
                      const RigidBody &body);
} // namespace contrecoup::gas

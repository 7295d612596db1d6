// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/node_fields.h>

#include <vector>

namespace contrecoup::solid
{
/**
 * One central-difference step: computes velocities at the middle of the next
 * step from the present forces, then displacements at its end, and sets forces
 * to zero. Marks blocks of moving nodes as active. Blocks that are neither
 * active nor loaded are skipped, which does not change results.
 * @param counted whether this rank counts a node in sums
 * @param before size of the last step [s]
 * @param next size of the next step [s]
 * @return work of the forces on counted nodes from the middle of the last step
 * to the middle of the next one [J]
 */
template <typename Real>
double move_nodes(NodeFields<Real> &nodes,
                  const std::vector<unsigned char> &counted,
                  const double before,
                  const double next);

/// The part of the work of move_nodes() in the half step that ends at the
/// present [J].
template <typename Real>
double work_until_now(const NodeFields<Real> &nodes,
                      const std::vector<unsigned char> &counted,
                      const double before);
} // namespace contrecoup::solid

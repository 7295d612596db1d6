// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/node_fields.h>

#include <vector>

namespace contrecoup::solid
{
/**
 * One step of central differences: velocities in the middle of the next step
 * from forces at the present, displacements at its end; forces are then zero.
 * Blocks of nodes that move from then on are awake; those that have no forces
 * and are not are passed over, which is the same.
 * @param before size of the last step [s]
 * @param next size of the next one [s]
 * @return work of the forces from the middle of the last step to the middle
 *   of the next one, of nodes that are counted here [J]
 */
template <typename Real>
double move_nodes(NodeFields<Real> &nodes,
                  const std::vector<unsigned char> &counted,
                  const double before,
                  const double next);

/// The part of that work in the half step that ends at the present [J].
template <typename Real>
double work_until_now(const NodeFields<Real> &nodes,
                      const std::vector<unsigned char> &counted,
                      const double before);
} // namespace contrecoup::solid

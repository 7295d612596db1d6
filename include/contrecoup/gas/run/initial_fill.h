// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/scene/gas_scene.h>
#include <contrecoup/gas/state/gas_field.h>

#include <string>
#include <vector>

namespace contrecoup::gas
{
/**
 * Fills the owned leaves of @p field with the initial state of @p scene and its
 * charges. Collective.
 * @param rough whether profiles are mapped only as accurately as the sensors
 * need
 * @return lines for the log
 */
template <int dim>
std::vector<std::string> fill_initial_state(const GasScene<dim> &scene,
                                            const LeafMesh<dim> &mesh,
                                            GasField &field,
                                            const bool rough);

/// Whether the leaf must be refined because it contains a discontinuity of the
/// initial state, judged by InitialState::distance_to_feature(); the sensors
/// find smooth variations.
template <int dim>
bool varies_in_leaf(const GasScene<dim> &scene,
                    const LeafMesh<dim> &mesh,
                    const unsigned int leaf);
} // namespace contrecoup::gas

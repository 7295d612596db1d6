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
 * Fills the owned leaves of @p field with the initial state of @p scene, and
 * with its charges. Collective.
 * @param rough whether profiles are mapped well enough for sensors alone
 * @return lines for the log about what was made
 */
template <int dim>
std::vector<std::string> fill_initial_state(const GasScene<dim> &scene,
                                            const LeafMesh<dim> &mesh,
                                            GasField &field,
                                            const bool rough);

/// Whether the initial state varies in a leaf so that it should be halved, as
/// far as distances tell; sensors find the shape of smooth fields.
template <int dim>
bool varies_in_leaf(const GasScene<dim> &scene,
                    const LeafMesh<dim> &mesh,
                    const unsigned int leaf);
} // namespace contrecoup::gas

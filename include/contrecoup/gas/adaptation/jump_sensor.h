// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/materials/gas_material.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Curvature sensor of density and pressure in each owned leaf: the largest
 * ratio
 *
 *   |s_+ - s_-| / (|s_+| + |s_-| + noise (|q_+| + 2 |q| + |q_-|) / h)
 *
 * over its points and directions, with s the divided differences to the
 * neighbouring points and h their mean distance (Loehner 1987, eq. 9). It is 0
 * for linear fields and close to 1 at jumps that exceed the noise. Ghosts of
 * @p field must be up to date.
 * @param wanted per batch: whether to compute it; the result is zero elsewhere
 * @param pressure_only whether to ignore the density
 */
template <int dim>
std::vector<double> jump_sensor(const LeafMesh<dim> &mesh,
                                const LeafPoints<dim> &points,
                                const GasMaterial &material,
                                const GasField &field,
                                const double noise,
                                const std::vector<bool> &wanted,
                                const bool pressure_only = false);
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/materials/gas_material.h>

#include <array>
#include <vector>

namespace contrecoup::gas
{
/**
 * Where pressure fronts stand: rise / (rise + noise) in each owned leaf, with
 * the largest
 *
 *   rise = sum_i |p_i+1 - p_i| / min(p_i, p_i+1)
 *            (div u)^2 / ((div u)^2 + |curl u|^2)
 *
 * over its lines of points and their next points beyond, over those i where
 * the pressure rises towards one end of the line and the gas does not expand
 * along it. So a front counts by its strength, however many points it is
 * wide. The factor is that of Ducros et al. (1999), which tells compression
 * waves from vortices; density does not enter, so that contacts are not seen.
 *
 * @param noise rise that gives one half [-]
 * @param field ghosts must be up to date
 * @param wanted per batch: whether to look at it; others give zero
 */
template <int dim>
std::vector<double> front_sensor(const LeafMesh<dim> &mesh,
                                 const LeafPoints<dim> &points,
                                 const GasMaterial &material,
                                 const GasField &field,
                                 const double noise,
                                 const std::vector<bool> &wanted);

/// A value for each face of a leaf.
template <int dim>
using FaceValues = std::array<double, 2 * dim>;

/**
 * The same for each face of a leaf by itself: of fronts whose pressure falls
 * towards that face, where they run to. The largest of a leaf is
 * front_sensor().
 */
template <int dim>
std::vector<FaceValues<dim>>
front_sensor_by_face(const LeafMesh<dim> &mesh,
                     const LeafPoints<dim> &points,
                     const GasMaterial &material,
                     const GasField &field,
                     const double noise,
                     const std::vector<bool> &wanted);
} // namespace contrecoup::gas

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
 * Sensor of pressure fronts: rise / (rise + noise) in each owned leaf, with
 * the largest
 *
 *   rise = sum_i |p_i+1 - p_i| / min(p_i, p_i+1)
 *            (div u)^2 / ((div u)^2 + |curl u|^2)
 *
 * over its lines of points, extended by one point beyond either end. The sum
 * is over the intervals i where the pressure rises towards one end of the line
 * and the gas does not expand along it. The value of a front thus depends on
 * its strength and not on the number of points across it. The last factor
 * distinguishes compression from vortices (Ducros et al. 1999). The density
 * does not enter, so that contacts are not detected.
 *
 * @param noise rise for which the sensor is one half [-]
 * @param field ghosts must be up to date
 * @param wanted per batch: whether to compute it; the result is zero elsewhere
 */
template <int dim>
std::vector<double> front_sensor(const LeafMesh<dim> &mesh,
                                 const LeafPoints<dim> &points,
                                 const GasMaterial &material,
                                 const GasField &field,
                                 const double noise,
                                 const std::vector<bool> &wanted);

/// One value per face of a leaf.
template <int dim>
using FaceValues = std::array<double, 2 * dim>;

/**
 * Front sensor per face of a leaf: of fronts whose pressure falls towards that
 * face, the side to which they propagate. The maximum over the faces of a leaf
 * is front_sensor().
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

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/profile.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/gas_state.h>
#include <contrecoup/materials/gas_material.h>

namespace contrecoup::gas
{
/**
 * A box around all cells that differ from the ambient state by more than a
 * relative 1e-10 in density or energy or as much in momentum: what cells
 * beyond it lack is below round-off of the whole. Empty (lower above upper)
 * when nothing does. Collective.
 */
template <int dim>
std::pair<dealii::Point<dim>, dealii::Point<dim>>
disturbed_box(const LeafMesh<dim> &mesh,
              const LeafPoints<dim> &points,
              const GasField &field,
              const std::vector<double> &ambient);

/**
 * The profile of a field in spherical, cylindrical or axisymmetric geometry:
 * its disturbed box on a raster of subcells as fine as the finest leaf there;
 * coarser leaves are halved as in adaptation. Every rank gets all of it. The
 * caller fills in what it knows besides: time, material, version.
 * @param ambient the undisturbed state, at rest
 * @throws InputError in plane geometry and when nothing is disturbed
 */
template <int dim>
ProfileData extract_profile(const LeafMesh<dim> &mesh,
                            const LeafPoints<dim> &points,
                            const GasField &field,
                            const GasMaterial &material,
                            const GasState<dim> &ambient);
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/gas/conditions/reference_solution.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/leaf_sampling.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Totals of the conserved quantities over the whole body of gas, and the
 * extremes of density and pressure. Collective.
 */
template <int dim>
std::vector<NamedValue> gas_totals(const LeafMesh<dim> &mesh,
                                   const LeafPoints<dim> &points,
                                   const GasField &field,
                                   const GasMaterial &material);

/**
 * Mean absolute (L1), root mean square (L2) and largest (Linf) difference
 * of density, velocity and pressure from the reference: of cell means for
 * finite volumes, of the polynomials for Galerkin schemes. For these, mean_L1
 * is the L1 error that finite volumes would report: of the nodal values from
 * the exact means over the nodes' subcells. Collective.
 */
template <int dim>
std::vector<NamedValue> gas_errors(const LeafMesh<dim> &mesh,
                                   const LeafPoints<dim> &points,
                                   const GasField &field,
                                   const GasMaterial &material,
                                   const ReferenceSolution<dim> &reference,
                                   const double time);
} // namespace contrecoup::gas

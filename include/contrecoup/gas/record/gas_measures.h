// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/gas/conditions/reference_solution.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/materials/gas_material.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Integrals of the conserved quantities over the gas (over the full angle in
 * curvilinear geometry), and the extremes of density and pressure. Collective.
 */
template <int dim>
std::vector<NamedValue> gas_totals(const LeafMesh<dim> &mesh,
                                   const LeafPoints<dim> &points,
                                   const GasField &field,
                                   const GasMaterial &material);

/**
 * Errors against the reference: mean absolute (L1), root mean square (L2) and
 * largest (Linf) error of density, velocity and pressure. Finite volumes
 * compare means of subcells, Galerkin schemes polynomials. Galerkin schemes
 * also report mean_L1, comparable to the L1 error of finite volumes: nodal
 * values against the exact means over the nodes' subcells. Collective.
 */
template <int dim>
std::vector<NamedValue> gas_errors(const LeafMesh<dim> &mesh,
                                   const LeafPoints<dim> &points,
                                   const GasField &field,
                                   const GasMaterial &material,
                                   const ReferenceSolution<dim> &reference,
                                   const double time);
} // namespace contrecoup::gas

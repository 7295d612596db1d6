// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>
#include <contrecoup/materials/gas_material.h>

#include <string>
#include <vector>

namespace contrecoup::gas
{
/**
 * Refuses, before anything is meshed, charges and a rigid body that are in
 * places where they cannot be: a charge out of the domain or cut by it off its
 * planes of symmetry although its mass is given, a charge that overlaps the
 * body or is nearer to it than a cell, and a body outside of the domain. Only
 * boxes are looked at. Meshes made coarser for trials of the costs (Rigid
 * body/Required = false) may have cells larger than the gap between charge
 * and body, and lose the body.
 *
 * @param prm with all entries
 * @param body may be empty
 * @throws InputError in one line with the entries that mend it
 */
template <int dim>
void check_places(ParameterHandler &prm,
                  const GasMaterial &material,
                  const CoarseMesh<dim> &mesh,
                  const RigidBody &body);

/**
 * Lines for the log about sides of the domain that cut the body and are no
 * planes of symmetry, by name or, if walls, as far as the body goes: what is
 * beyond them is not there. Cuts less deep than a cell at the body are not
 * worth a word.
 */
template <int dim>
std::vector<std::string> remarks_on_cuts(ParameterHandler &prm,
                                         const CoarseMesh<dim> &mesh,
                                         const RigidBody &body);

/// Largest distance from the centre to the surface of the charges [m], along
/// the coordinates of the mesh. 0 without any.
template <int dim>
double largest_charge_extent(ParameterHandler &prm,
                             const GasMaterial &material,
                             const CoarseMesh<dim> &mesh);
} // namespace contrecoup::gas

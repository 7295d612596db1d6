// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>
#include <contrecoup/materials/gas_material.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

namespace contrecoup::gas
{
/// Longest edge of the smallest subcells at the body [m].
/// @param subcells along the edge of a leaf
template <int dim>
double cell_at_body(const CoarseMesh<dim> &mesh,
                    const RigidBody &body,
                    const unsigned int subcells);

/**
 * Checks the positions of charges and rigid body before meshing. Rejects a
 * charge outside of the domain, a charge of given mass that the domain cuts
 * other than in planes of symmetry, a charge that overlaps the body or is
 * nearer to it than a subcell, and a body outside of the domain. Checks box
 * domains only. With "Rigid body/Required" = false (trial runs on coarser
 * meshes) the gap between charge and body may be smaller than a subcell, and
 * the body may cover no subcell.
 *
 * @param prm with all entries
 * @param body may be empty
 * @throws InputError, one line that names the entries to change
 */
template <int dim>
void check_places(ParameterHandler &prm,
                  const GasMaterial &material,
                  const CoarseMesh<dim> &mesh,
                  const RigidBody &body);

/**
 * Remarks for the log on sides of the domain that cut the body although they
 * are not planes of symmetry: the part of the body beyond them is missing. Cuts
 * shallower than a subcell at the body are not mentioned.
 */
template <int dim>
std::vector<std::string> remarks_on_cuts(ParameterHandler &prm,
                                         const CoarseMesh<dim> &mesh,
                                         const RigidBody &body);

/// Directions normal to planes of symmetry: those of which one side of a box is
/// "symmetry". The axis of curvilinear coordinates is none.
template <int dim>
std::array<bool, 3> planes_of_symmetry(ParameterHandler &prm,
                                       const CoarseMesh<dim> &mesh);

/**
 * Factors by which the components of the force on the modelled part of the body
 * become those on the whole body: two for each plane of symmetry that cuts the
 * body, and zero normal to it, as the images cancel it. So does the radial one
 * of an axisymmetric domain. Sides that are "wall" reflect nothing but the gas.
 *
 * @param body may be empty
 */
template <int dim>
dealii::Tensor<1, 3> factors_to_whole_body(ParameterHandler &prm,
                                           const CoarseMesh<dim> &mesh,
                                           const RigidBody &body);

/// Largest distance from the centre of a charge to its surface along the
/// coordinates of the mesh [m]; 0 without charges.
template <int dim>
double largest_charge_extent(ParameterHandler &prm,
                             const GasMaterial &material,
                             const CoarseMesh<dim> &mesh);
} // namespace contrecoup::gas

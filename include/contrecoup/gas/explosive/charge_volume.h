// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/explosive/charge.h>
#include <contrecoup/gas/octree/leaf_mesh.h>
#include <contrecoup/gas/octree/leaf_points.h>

#include <vector>

namespace contrecoup::gas
{
/// Fraction of each point's volume that a charge fills.
struct ChargeVolume
{
  struct Contribution
  {
    unsigned int leaf;
    unsigned int point;
    double fraction; ///< fraction of the point's volume, > 0 [-]
  };
  std::vector<Contribution> contributions; ///< on leaves of this rank
  double total = 0.;     ///< volume of the parts of all ranks [m^3]
  bool is_exact = false; ///< whether total equals the exact volume
};

/**
 * Computes the volume fractions of a charge in the points of a mesh. A charge
 * that is a box in the coordinates of a box mesh (in 1-D every charge) is
 * intersected exactly. Subcells cut by other surfaces are bisected in all
 * directions until the parts are small compared with subcell and charge;
 * within a part the surface is taken as plane. Then the fractions f of cut
 * subcells are changed by lambda f (1 - f), with one lambda, so that the
 * charge has its exact volume, if Charge::fraction_within() knows it.
 * Collective.
 */
template <int dim>
ChargeVolume charge_volume(const Charge<dim> &charge,
                           const LeafMesh<dim> &mesh,
                           const LeafPoints<dim> &points);
} // namespace contrecoup::gas

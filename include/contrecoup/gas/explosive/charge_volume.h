// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/explosive/charge.h>
#include <contrecoup/gas/octree/leaf_mesh.h>
#include <contrecoup/gas/state/leaf_sampling.h>

#include <vector>

namespace contrecoup::gas
{
/// How much of each point's volume a charge fills.
struct ChargeVolume
{
  struct Part
  {
    unsigned int leaf;
    unsigned int point;
    double fraction; ///< of the point's volume, above 0 [-]
  };
  std::vector<Part> parts; ///< of the leaves of this rank
  double total = 0.;       ///< volume of all ranks' parts [m^3]
  bool is_exact = false;   ///< whether total is that of the true shape
};

/**
 * Volume fractions of a charge in the subcells of a mesh. Charges that are
 * boxes in the coordinates of a box mesh (in 1-D all) are intersected
 * exactly. The cells that other surfaces cut are halved in all directions
 * until their parts are small beside cell and charge, and a plane surface is
 * assumed in each part. The fractions f of these cells are then changed by
 * lambda f (1 - f), with one lambda, so that the charge has its exact volume,
 * where Charge::share_within() knows it. Collective.
 */
template <int dim>
ChargeVolume charge_volume(const Charge<dim> &charge,
                           const LeafMesh<dim> &mesh,
                           const LeafPoints<dim> &points);
} // namespace contrecoup::gas

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/symmetry_planes.h>
#include <contrecoup/base/run/simulation.h>

namespace contrecoup::ale
{
/**
 * Converts results of the computed part of a body to those of the whole body.
 * Masses, energies, forces, areas, volumes and impulses are divided by
 * @p computed_fraction; momenta and mean velocities normal to symmetry planes
 * become zero.
 * @param values recognised by units and names
 * @param computed_fraction computed fraction of the body [-]
 */
void set_to_whole(std::vector<NamedValue> &values,
                  const double computed_fraction,
                  const SymmetryPlanes &planes);
} // namespace contrecoup::ale

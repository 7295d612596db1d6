// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/symmetry_planes.h>
#include <contrecoup/base/run/simulation.h>

namespace contrecoup::ale
{
/**
 * Converts results of the computed part of a body to those of the whole body.
 * Masses, energies, forces, areas, volumes and impulses are divided by @p
 * part; momenta and mean velocities normal to symmetry planes become zero.
 * @param values recognised by units and names
 * @param part that is computed [-]
 */
void set_to_whole(std::vector<NamedValue> &values,
                  const double computed_fraction,
                  const SymmetryPlanes &planes);
} // namespace contrecoup::ale

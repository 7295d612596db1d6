// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/symmetry_planes.h>
#include <contrecoup/base/simulation.h>

namespace contrecoup::ale
{
/**
 * Turns what was found of the computed part of a body into what the whole body
 * has: masses, energies, forces, areas, volumes and impulses are divided by the
 * part, and momenta and mean velocities across planes of symmetry are zero.
 * @param values told apart by their units and names
 * @param part that is computed [-]
 */
void set_to_whole(std::vector<NamedValue> &values,
                  const double part,
                  const SymmetryPlanes &planes);
} // namespace contrecoup::ale

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::coupling
{
/**
 * Does what Domain/Size = by time asks: moves the open sides of a box outwards,
 * by whole coarse leaves, until a wave from the charge that they sent back
 * would be at no probe and not at the body before the end time; the entries
 * "Lower corner", "Upper corner" and "Coarse leaves" are changed, and Size
 * becomes given. The front is that of ExpectedBlast with the energy that the
 * scene holds on a coarse mesh, and the path back is that from a mirror. Says
 * what it did. Collective.
 * @param scene every entry of application blast, without or with a first stage
 * @throws InputError without probes and body, for meshes other than boxes, and
 * where no blast can be foreseen.
 */
template <int dim>
void fit_domain(ParameterHandler &scene, const MPI_Comm communicator);
} // namespace contrecoup::coupling

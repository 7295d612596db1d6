// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameters.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::coupling
{
/**
 * Sizes the domain for Domain/Size = by time. Moves the open sides of a box
 * outwards, by whole coarse leaves, until the time to first reflection from an
 * open side at any probe, those of lines and planes too, and at the body is
 * later than the end time. Sets the entries "Lower corner", "Upper corner" and
 * "Coarse leaves", and Size to given. The front is that of
 * ModellingPlan::expected_reach() with the energy of the scene on a coarse
 * mesh; the path of a reflection is that from a mirror at the side. Logs the
 * result. Collective.
 * @param scene all entries of application blast, with or without a first stage
 * @throws InputError without probes and body, for meshes other than boxes, and
 * for scenes whose blast cannot be predicted.
 */
template <int dim>
void fit_domain(ParameterHandler &scene, const MPI_Comm communicator);
} // namespace contrecoup::coupling

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/mpm/particle_material.h>
#include <contrecoup/mpm/particles.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::ale
{
/// As region_measures(), for particles: names end with that of the material.
/// Collective.
std::vector<NamedValue>
particle_measures(const std::vector<mpm::ParticleMaterial> &materials,
                  const mpm::Particles &particles,
                  const MPI_Comm communicator);
} // namespace contrecoup::ale

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_material.h>
#include <contrecoup/mpm/particles.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

namespace contrecoup::mpm
{
/// Writes the particles as points with their velocity, density, pressure,
/// shear strain, volume and material. Collective.
/// @return name of the file to open, without its folder
std::string write_particles(const std::vector<ParticleMaterial> &materials,
                            const Particles &particles,
                            const std::string &folder,
                            const unsigned int index,
                            const MPI_Comm communicator);
} // namespace contrecoup::mpm

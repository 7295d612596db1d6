// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/region_extremes.h>
#include <contrecoup/base/run/simulation.h>
#include <contrecoup/mpm/particle_material.h>
#include <contrecoup/mpm/particles.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::ale
{
/// Extremes of each material in the particles of this rank.
std::vector<RegionExtremes>
particle_extremes(const std::vector<mpm::ParticleMaterial> &materials,
                  const mpm::Particles &particles);

/// As region_measures(), for particles: names end with that of the material.
/// Collective. @param extremes of each material, of all ranks
std::vector<NamedValue>
particle_measures(const std::vector<mpm::ParticleMaterial> &materials,
                  const mpm::Particles &particles,
                  const std::vector<RegionExtremes> &extremes,
                  const MPI_Comm communicator);
} // namespace contrecoup::ale

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_material.h>

namespace contrecoup::mpm
{
/// Implements strain_particles() for metals.
void strain_metals(const ParticleMaterial &material,
                   const double step,
                   const double cell_size,
                   ParticleBlock &particles);

/// Elastic energy of a metal particle per undeformed volume [J/m^3].
double metal_energy(const SolidMaterial &solid,
                    const ParticleBlock &particles,
                    const std::size_t particle);
} // namespace contrecoup::mpm

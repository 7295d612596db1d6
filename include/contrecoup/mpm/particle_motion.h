// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_block.h>

namespace contrecoup::mpm
{
/// Energy that particles got in a step [J].
struct EnergyGains
{
  double work = 0.;    ///< of forces from outside
  double kinetic = 0.; ///< kinetic energy
};

/**
 * Gives particles the velocity after a step and the energy that their stresses
 * did, from column::change, way and mean_rate.
 * @param grid_velocity_fraction 0: the change is added to the old velocity; 1:
 * the velocity is that of the way; between, a part of each [-]
 * @param is_smoothed whether column::smoothed is a pressure besides the stress
 */
EnergyGains update_velocities(const double step,
                              const double grid_velocity_fraction,
                              const bool is_smoothed,
                              ParticleBlock &particles);

/// Adds column::way to positions.
void advance_positions(ParticleBlock &particles);

/// The largest entry of column::mean_rate [1/s]; infinity if one is not finite.
double largest_rate(const ParticleBlock &particles);

/// Whether all particles are in a box, from lower to below upper, both over the
/// cell size after @p origin is subtracted.
bool are_inside(const ParticleBlock &particles,
                const double *const origin,
                const double cell_size,
                const int *const lower,
                const int *const upper);
} // namespace contrecoup::mpm

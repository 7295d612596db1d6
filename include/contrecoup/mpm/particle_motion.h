// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_block.h>

namespace contrecoup::mpm
{
/// Energy that particles gained in a step [J].
struct EnergyGains
{
  double work = 0.;    ///< of external forces
  double kinetic = 0.; ///< kinetic energy
};

/**
 * Sets the velocities of particles after a step and adds the work of their
 * stresses to the internal energy, from column::velocity_change,
 * position_change and mean_rate.
 * @param grid_velocity_fraction weight of the grid velocity [-]. 0: the
 * velocity change is added to the old velocity; 1: the velocity is the position
 * change over the step size; values between interpolate
 * @param is_smoothed whether column::smoothed is a pressure in addition to the
 * stress
 */
EnergyGains update_velocities(const double step,
                              const double grid_velocity_fraction,
                              const bool is_smoothed,
                              ParticleBlock &particles);

/// Adds column::position_change to positions.
void advance_positions(ParticleBlock &particles);

/// Largest absolute entry of column::mean_rate [1/s]; infinity if an entry is
/// not finite.
double largest_rate(const ParticleBlock &particles);

/// Whether all particles are inside a box: lower <= (x - origin) / cell_size <
/// upper in each direction.
bool are_inside(const ParticleBlock &particles,
                const double *const origin,
                const double cell_size,
                const int *const lower,
                const int *const upper);
} // namespace contrecoup::mpm

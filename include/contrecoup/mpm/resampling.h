// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_block.h>
#include <contrecoup/mpm/tile_grid.h>

#include <cstddef>
#include <vector>

/**
 * @file
 * Resampling: splits particles where matter is stretched, and merges them
 * where cells contain too many. Mass, momentum, angular momentum, and the sum
 * of kinetic and internal energy are conserved up to round-off.
 */

namespace contrecoup::mpm
{
/**
 * Splits particles of solids whose length along a principal direction has
 * become @p stretch times the undeformed one. The two halves lie on that
 * direction, at a quarter of the present length from the position of the
 * particle, and have its velocity, strain and stress. A half is split again
 * when its stretch has grown by the same factor.
 * @return number of particles that were split
 */
std::size_t split_stretched(const double stretch, ParticleBlock &particles);

/**
 * Merges four particles into two in cells of a tile with more than @p
 * max_per_cell particles of a material. Each of the two has half of the mass.
 * Their distance from the common centre of mass is the root mean square of that
 * of the four, along a direction normal to the angular momentum about it, which
 * their velocities conserve. The remaining kinetic energy becomes internal
 * energy. Strains and stresses are volume-weighted means. Particles that a
 * probe follows or that carry surface area are not merged.
 * @return reduction of the number of particles
 */
std::size_t merge_crowded(const std::size_t max_per_cell,
                          const TileGrid &grid,
                          ParticleBlock &particles);
} // namespace contrecoup::mpm

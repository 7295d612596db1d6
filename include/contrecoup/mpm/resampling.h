// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_block.h>
#include <contrecoup/mpm/tile_grid.h>

#include <cstddef>
#include <vector>

/**
 * @file
 * More particles where matter is stretched, fewer where it is crowded. Mass,
 * momentum, angular momentum, and kinetic and internal energy together are
 * kept to round-off.
 */

namespace contrecoup::mpm
{
/**
 * Splits particles of solids whose length along a principal direction has
 * become @p stretch times what it was: two halves lie on that direction, a
 * quarter of the length from where the particle was, and have its velocity,
 * strain and stress. A half is split when it is stretched as much again.
 * @return how many were split
 */
std::size_t split_stretched(const double stretch, ParticleBlock &particles);

/**
 * Makes two of four particles in the cells of a tile that have more than
 * @p max_per_cell of a material: they have half of the mass each, and lie as
 * far from the centre of mass as the four did in the mean square, across their
 * angular momentum about it, which their velocities keep; what kinetic energy
 * is left becomes internal energy. Strains and stresses are means by volume.
 * Particles that a probe follows or that touch the surface stay.
 * @return how many are fewer
 */
std::size_t merge_crowded(const std::size_t max_per_cell,
                          const TileGrid &grid,
                          ParticleBlock &particles);
} // namespace contrecoup::mpm

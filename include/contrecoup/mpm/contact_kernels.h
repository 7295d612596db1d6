// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_block.h>
#include <contrecoup/mpm/transfer_kernels.h>

/**
 * @file
 * Sums and extrema over particles for the contact of velocity fields, in the
 * window of a tile, component by component.
 */

namespace contrecoup::mpm
{
/// Adds the gradient of the mass that particles give to nodes: 3 components.
void add_mass_gradient(const unsigned int degree,
                       const ParticleBlock &particles,
                       const WindowGeometry &geometry,
                       double *window);

/// From particles to their faces.
struct ParticleExtent
{
  double spacing;    ///< of a particle that fills its box [m]
  double box_volume; ///< [m^3]
};

/**
 * Raises, at nodes in whose splines particles are, how far these reach from the
 * node along its normal times @p sign; faces of particles that fill only a
 * part of their boxes are as much nearer.
 * @param normals 3 components; zero: the node is left alone
 * @param extents [m]
 */
void update_extents(const unsigned int degree,
                    const ParticleBlock &particles,
                    const WindowGeometry &geometry,
                    const double sign,
                    const ParticleExtent &half,
                    const double *normals,
                    double *extents);
} // namespace contrecoup::mpm

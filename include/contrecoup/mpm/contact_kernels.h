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
/// Adds the mass gradient sum_p m_p grad N_i(x_p) at each node: 3 components
/// [kg/m].
void add_mass_gradient(const unsigned int degree,
                       const ParticleBlock &particles,
                       const WindowGeometry &geometry,
                       double *window);

/// Size of the cube domain of a particle, from which the position of its faces
/// follows.
struct ParticleExtent
{
  /// Distance from a particle to its face if its box is full [m].
  double spacing;
  double box_volume; ///< [m^3]
};

/**
 * Raises @p extents to the largest distance from the node to the faces of the
 * particles in its spline support, along @p sign times the node's normal. The
 * face of a particle that fills only a fraction of its box is nearer
 * accordingly.
 * @param normals 3 components; zero: the node is skipped
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

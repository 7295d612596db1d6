// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/node_values.h>
#include <contrecoup/mpm/particle_block.h>

#include <array>

/**
 * @file
 * Transfers between a block of particles and the window of its tile. The
 * components of a window are window_stride apart.
 */

namespace contrecoup::mpm
{
/// Position and cell size of a tile's window.
struct WindowGeometry
{
  std::array<double, 3> lower; ///< position of the tile's first node [m]
  double cell_size;            ///< [m]
};

/// Geometry of the window of a tile with particles.
WindowGeometry window_geometry(const TileGrid &grid,
                               const TileGrid::Source &tile);

/// Quantities that one call transfers from particles to nodes.
enum class Deposit
{
  momentum,       ///< mass and momentum: 4 components
  momentum_force, ///< mass, momentum, and the force of stresses and external
                  ///< forces: 7
  force           ///< only that force: 3
};

/**
 * Adds mass, momentum and force to the window.
 * @param affine whether momentum includes the affine velocity of the particles
 */
void deposit(const unsigned int degree,
             const Deposit what,
             const bool affine,
             const ParticleBlock &particles,
             const WindowGeometry &geometry,
             double *window);

/// Sets column::velocity_change to step * sum N a, column::position_change to
/// step * sum N v with the velocity v after the step, and column::mean_rate to
/// the gradient of the mean velocity. @param window acceleration a, mean
/// velocity: 6 components
void collect_motion(const unsigned int degree,
                    const double step,
                    const double *window,
                    const WindowGeometry &geometry,
                    ParticleBlock &particles);

/// Sets column::velocity_gradient. @param window velocity: 3 components
void collect_rate(const unsigned int degree,
                  const double *window,
                  const WindowGeometry &geometry,
                  ParticleBlock &particles);

/// Sets column::affine to the least squares affine fit of the nodal velocities.
/// @param window velocity: 3 components
void collect_affine(const unsigned int degree,
                    const double *window,
                    const WindowGeometry &geometry,
                    ParticleBlock &particles);

/// Multiplies nodal vectors with the consistent mass matrix.
/// @param from,to vectors, 3 components for each of @p n_vectors
void multiply_mass(const unsigned int degree,
                   const unsigned int n_vectors,
                   const ParticleBlock &particles,
                   const WindowGeometry &geometry,
                   const double *from,
                   double *to);

/// Adds weights, and weights times values, to nodes with linear splines: 2
/// components.
void deposit_scalar(const ParticleBlock &particles,
                    const double *weight,
                    const double *value,
                    const WindowGeometry &geometry,
                    double *window);

/// Interpolates a nodal scalar to the particles with linear splines.
void collect_scalar(const double *window,
                    const WindowGeometry &geometry,
                    const ParticleBlock &particles,
                    double *value);
} // namespace contrecoup::mpm

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/node_values.h>
#include <contrecoup/mpm/particle_block.h>

#include <array>

/**
 * @file
 * Sums over particles and over nodes, between a block of particles and the
 * window of its tile. Windows are component by component, window_stride
 * apart.
 */

namespace contrecoup::mpm
{
/// Where a tile's window is.
struct WindowGeometry
{
  std::array<double, 3> lower; ///< the tile's first node [m]
  double cell_size;            ///< [m]
};

/// That of a tile with particles.
WindowGeometry window_geometry(const TileGrid &grid,
                               const TileGrid::Source &tile);

/// What goes from particles to nodes at once.
enum class Deposit
{
  momentum,       ///< mass and momentum: 4 components
  momentum_force, ///< and the force of stress and from outside: 7
  force           ///< that force alone: 3
};

/**
 * Adds mass, momentum and force.
 * @param affine whether momentum has the particles' affine part
 */
void deposit(const unsigned int degree,
             const Deposit what,
             const bool affine,
             const ParticleBlock &particles,
             const WindowGeometry &geometry,
             double *window);

/// Sets column::change to step times the sum of N a, column::way to step
/// times that of N v after it, and column::mean_rate to the gradient of the
/// mean velocity. @param window acceleration, mean velocity: 6 components
void collect_motion(const unsigned int degree,
                    const double step,
                    const double *window,
                    const WindowGeometry &geometry,
                    ParticleBlock &particles);

/// Sets column::rate. @param window velocity: 3 components
void collect_rate(const unsigned int degree,
                  const double *window,
                  const WindowGeometry &geometry,
                  ParticleBlock &particles);

/// Sets column::affine to the best affine fit of the velocity's nodes.
/// @param window velocity: 3 components
void collect_affine(const unsigned int degree,
                    const double *window,
                    const WindowGeometry &geometry,
                    ParticleBlock &particles);

/// Product of the consistent mass matrix with vectors of nodes.
/// @param from,to vectors: 3 components times @p n_vectors
void multiply_mass(const unsigned int degree,
                   const unsigned int n_vectors,
                   const ParticleBlock &particles,
                   const WindowGeometry &geometry,
                   const double *from,
                   double *to);

/// Adds weight and weight times value by linear splines: 2 components.
void deposit_scalar(const ParticleBlock &particles,
                    const double *weight,
                    const double *value,
                    const WindowGeometry &geometry,
                    double *window);

/// Reads a scalar of the nodes by linear splines.
void collect_scalar(const double *window,
                    const WindowGeometry &geometry,
                    const ParticleBlock &particles,
                    double *value);
} // namespace contrecoup::mpm

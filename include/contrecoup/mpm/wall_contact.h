// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/particle_material.h>
#include <contrecoup/mpm/particles.h>
#include <contrecoup/mpm/seeding.h>
#include <contrecoup/mpm/tile_grid.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace contrecoup::mpm
{
/// A rigid plane at rest, or the inside of a rigid sphere at rest.
struct RigidWall
{
  std::string name;
  dealii::Point<3> point;      ///< of the plane, or the sphere's centre
  dealii::Tensor<1, 3> normal; ///< of length 1, into the side of the matter
  double friction = 0.;        ///< Coulomb's coefficient [-]
  double radius = 0.;          ///< of the sphere; 0: it is a plane [m]
  bool is_adhesive = false;    ///< whether it pulls matter back, too

  /// How far a place is behind the wall [m].
  double depth(const dealii::Point<3> &place) const
  {
    return radius > 0. ? place.distance(point) - radius
                       : (point - place) * normal;
  }

  /// Into the side of the matter, at a place.
  dealii::Tensor<1, 3> normal_at(const dealii::Point<3> &place) const
  {
    return radius > 0. ? (point - place) / point.distance(place) : normal;
  }
};

/// What walls do, this rank's part.
struct WallMeasures
{
  double force = 0.;          ///< along the normals [N]
  double area = 0.;           ///< of the surface in contact [m^2]
  double friction_power = 0.; ///< at most 0 [W]
  /// That a coefficient of 1 would take in a step as the last one [J].
  double sliding = 0.;
};

/**
 * Rigid walls that press on the pieces of the body's surface which have come
 * behind them: by a stiffness times the depth, so that the gap between a wall
 * and the body is that of their surfaces, not that of the splines of the grid,
 * and its energy comes back. The stiffness is that of a layer of the particle's
 * own material, a part of a cell thick. Every particle next to the surface
 * carries the way to its piece of it, which is strained with the particle.
 */
class WallContact
{
public:
  /// @param thickness of the layer over the cell size [-]
  explicit WallContact(const std::vector<RigidWall> &walls = {},
                       const double thickness = 0.5)
    : walls_(walls)
    , thickness_(thickness)
  {}

  bool empty() const
  {
    return walls_.empty();
  }
  const std::vector<RigidWall> &walls() const
  {
    return walls_;
  }

  /**
   * Gives pieces of the surface to the particles: parallel lines from the
   * planes hit the body, spheres are full of it; each piece belongs to the
   * nearest particle. Call
   * once, after seeding.
   * @throws InputError for a plane that cuts the body. Collective.
   */
  void find_surface(const ParticleSource &source,
                    const TileGrid &grid,
                    Particles &particles) const;

  /// Adds forces to column::force.
  void add_forces(const ParticleMaterial &material,
                  const TileGrid &grid,
                  ParticleBlock &particles);

  /// Forgets what add_forces() has measured.
  void clear_measures()
  {
    measures_ = WallMeasures();
  }

  /// Since clear_measures().
  const WallMeasures &measures() const
  {
    return measures_;
  }

private:
  void find_at_plane(const RigidWall &wall,
                     const ParticleSource &source,
                     const TileGrid &grid,
                     Particles &particles) const;
  void find_at_sphere(const RigidWall &wall,
                      const ParticleSource &source,
                      const TileGrid &grid,
                      Particles &particles) const;
  void apply_force(const RigidWall &wall,
                   const double stiffness,
                   const std::size_t particle,
                   ParticleBlock &particles);

  std::vector<RigidWall> walls_;
  double thickness_;
  WallMeasures measures_;
};
} // namespace contrecoup::mpm

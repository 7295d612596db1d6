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
  dealii::Tensor<1, 3> normal; ///< unit normal, towards the matter
  double friction = 0.;        ///< Coulomb's coefficient [-]
  double radius = 0.;          ///< radius of the sphere; 0: plane [m]
  bool is_adhesive = false;    ///< whether the wall also pulls matter back

  /// Penetration depth of a position behind the wall [m]; negative in front of
  /// it.
  double depth(const dealii::Point<3> &place) const
  {
    return radius > 0. ? place.distance(point) - radius
                       : (point - place) * normal;
  }

  /// Unit normal at a position, towards the matter.
  dealii::Tensor<1, 3> normal_at(const dealii::Point<3> &place) const
  {
    return radius > 0. ? (point - place) / point.distance(place) : normal;
  }
};

/// Contact measures of walls, of this rank.
struct WallMeasures
{
  double force = 0.;          ///< force along the normals [N]
  double area = 0.;           ///< contact area [m^2]
  double friction_power = 0.; ///< power of friction, not positive [W]
  /// Frictional work that a coefficient of 1 would dissipate in the last step
  /// [J].
  double sliding = 0.;
};

/**
 * Contact with rigid walls by a penalty method: surface elements of the body
 * behind a wall get a force of stiffness times penetration depth. Hence the gap
 * is measured between the surfaces, not between spline supports of the grid,
 * and the energy of the contact is recovered. The stiffness is that of a layer
 * of the particle's own material with a thickness of a fraction of a cell.
 * Every particle next to the surface stores the vector to its surface element,
 * which deforms with the particle.
 */
class WallContact
{
public:
  /// @param thickness thickness of the layer over the cell size [-]
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
   * Assigns surface elements to particles: where parallel lines from a plane
   * hit the body, and all of a sphere, which the body fills. Each element
   * belongs to the nearest particle. Call once, after seeding.
   * @throws InputError for a plane that intersects the body. Collective.
   */
  void find_surface(const ParticleSource &source,
                    const TileGrid &grid,
                    Particles &particles) const;

  /// Adds the contact forces to column::force.
  void add_forces(const ParticleMaterial &material,
                  const TileGrid &grid,
                  ParticleBlock &particles);

  /// Resets measures().
  void clear_measures()
  {
    measures_ = WallMeasures();
  }

  /// Measures since clear_measures().
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

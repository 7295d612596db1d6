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
/// A rigid plane at rest.
struct RigidPlane
{
  std::string name;
  dealii::Point<3> point;
  dealii::Tensor<1, 3> normal; ///< of length 1, into the side of the matter
  double friction = 0.;        ///< Coulomb's coefficient [-]
};

/// What planes do, this rank's part.
struct WallMeasures
{
  double force = 0.; ///< along the normals [N]
  double area = 0.;  ///< of the surface in contact [m^2]
};

/**
 * Rigid planes that press on the pieces of the body's surface which have come
 * behind them: by a stiffness times the depth, so that the gap between a plane
 * and the body is that of their surfaces, not that of the splines of the grid,
 * and its energy comes back. The stiffness is that of a layer of the particle's
 * own material, a part of a cell thick. Every particle next to the surface
 * carries the way to its piece of it, which is strained with the particle.
 */
class WallContact
{
public:
  /// @param thickness of the layer over the cell size [-]
  explicit WallContact(const std::vector<RigidPlane> &planes = {},
                       const double thickness = 0.5)
    : planes_(planes)
    , thickness_(thickness)
  {}

  bool empty() const
  {
    return planes_.empty();
  }
  const std::vector<RigidPlane> &planes() const
  {
    return planes_;
  }

  /**
   * Gives pieces of the surface to the particles: parallel lines from the
   * planes hit the body, and each hit belongs to the nearest particle. Call
   * once, after seeding.
   * @throws InputError for a plane that cuts the body. Collective.
   */
  void find_surface(const ParticleSource &source,
                    const TileGrid &grid,
                    Particles &particles) const;

  /// Adds forces to column::force.
  void add_forces(const ParticleMaterial &material,
                  const double cell_size,
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
  std::vector<RigidPlane> planes_;
  double thickness_;
  WallMeasures measures_;
};
} // namespace contrecoup::mpm

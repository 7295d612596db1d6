// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/materials/solid_material.h>
#include <contrecoup/numerics/hex8_geometry.h>
#include <contrecoup/solid/body/solid_mesh.h>

#include <vector>

namespace contrecoup::solid
{
/// A bound of the square of the largest angular frequency [1/s^2] of an element
/// alone: exact for a cube.
double element_square_frequency(const HexGeometry<double> &geometry,
                                const SolidMaterial &material);

/**
 * Mass that is added to elements whose own stable step is too small. It is no
 * inertia that the body has: what was added is to be reported, by tissue.
 */
class MassScaling
{
public:
  /**
   * @param materials by tissue of the mesh
   * @param smallest_step that an element shall have alone [s]; 0 adds nothing
   * Collective.
   */
  void reinit(const SolidMesh &mesh,
              const std::vector<SolidMaterial> &materials,
              const double smallest_step,
              MPI_Comm communicator);

  bool active() const
  {
    return active_;
  }

  /// Adds what the elements of this rank got to the masses of their nodes [kg].
  void add_to(std::vector<double> &masses) const;

  /// Kinetic energy of the added mass of a tissue [J], of this rank, from the
  /// squares of nodes' velocities [m^2/s^2].
  template <typename Real>
  double kinetic_energy(const unsigned int tissue,
                        const std::vector<Real> &squares) const;

  /// Number of scaled elements and added mass, by tissue of all ranks.
  const std::vector<NamedValue> &report() const
  {
    return report_;
  }

private:
  /// An element's node with its share.
  struct Share
  {
    std::uint32_t node;
    double mass; ///< [kg]
  };

  bool active_ = false;
  std::vector<std::vector<Share>> shares_; ///< by tissue
  std::vector<NamedValue> report_;
};
} // namespace contrecoup::solid

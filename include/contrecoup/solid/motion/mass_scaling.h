// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/materials/solid_material.h>
#include <contrecoup/numerics/element/hex8_geometry.h>
#include <contrecoup/solid/body/solid_mesh.h>

#include <vector>

namespace contrecoup::solid
{
/// Upper bound of the squared largest angular frequency of a single free
/// element [1/s^2]; exact for a cube.
double element_square_frequency(const HexGeometry<double> &geometry,
                                const SolidMaterial &material);

/// Mass scaling: adds mass to elements whose own stable step is too small. The
/// added mass is false inertia, so it is reported by tissue.
class MassScaling
{
public:
  /**
   * Computes the added masses. Collective.
   * @param materials by tissue of the mesh
   * @param smallest_step least stable step of a single element [s]; 0: no
   * scaling
   */
  void reinit(const SolidMesh &mesh,
              const std::vector<SolidMaterial> &materials,
              const double smallest_step,
              MPI_Comm communicator);

  bool active() const
  {
    return active_;
  }

  /// Adds the added mass of this rank's elements to the nodal masses [kg].
  void add_to(std::vector<double> &masses) const;

  /// Kinetic energy of the added mass of a tissue [J], of this rank. @param
  /// squares squared velocity of each node [m^2/s^2]
  template <typename Real>
  double kinetic_energy(const unsigned int tissue,
                        const std::vector<Real> &squares) const;

  /// Number of scaled elements and added mass by tissue, of all ranks.
  const std::vector<NamedValue> &report() const
  {
    return report_;
  }

private:
  /// Mass that scaled elements add to a node.
  struct NodalMass
  {
    std::uint32_t node;
    double mass; ///< [kg]
  };

  bool active_ = false;
  std::vector<std::vector<NodalMass>> nodal_masses_; ///< by tissue
  std::vector<NamedValue> report_;
};
} // namespace contrecoup::solid

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/expression.h>
#include <contrecoup/base/run/simulation.h>
#include <contrecoup/mpm/particle_material.h>
#include <contrecoup/mpm/particles.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::ale
{
/// Number of the material of this name.
/// @throws InputError that names @p entry and suggests the nearest name
unsigned int find_material(const std::vector<mpm::ParticleMaterial> &materials,
                           const std::string &entry,
                           const std::string &name);

/// Extents of sets of particles against known values: subsections "Extent *".
class ParticleExtents
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads them from "Reference". @throws InputError for invalid entries
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Finds the regions by name. @throws InputError for unknown names
  void reinit(const std::vector<mpm::ParticleMaterial> &materials);

  bool empty() const
  {
    return extents_.empty();
  }

  /// Extents extent_NAME [m] of particles with their deformed cube domains; 0
  /// without particles. Collective.
  std::vector<NamedValue> values(const mpm::Particles &particles,
                                 const MPI_Comm communicator) const;

  /// Relative errors extent_NAME, as absolute values [-], and a warning for an
  /// extent without particles, whose error is unknown. Collective.
  std::vector<NamedValue> errors(const mpm::Particles &particles,
                                 const MPI_Comm communicator) const;

private:
  /// Farthest position of the particles of each extent [m]. Collective.
  std::vector<double> farthest(const mpm::Particles &particles,
                               const MPI_Comm communicator) const;

  struct Extent
  {
    std::string name, region;
    unsigned int material, direction;
    Expression where;
    double known; ///< [m]
  };

  std::vector<Extent> extents_;
};
} // namespace contrecoup::ale

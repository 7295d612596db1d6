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

  /// Relative errors extent_NAME, as absolute values [-]. Collective.
  std::vector<NamedValue> errors(const mpm::Particles &particles,
                                 const MPI_Comm communicator) const;

private:
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

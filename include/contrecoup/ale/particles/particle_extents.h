// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/expression.h>
#include <contrecoup/base/simulation.h>
#include <contrecoup/mpm/particle_material.h>
#include <contrecoup/mpm/particles.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::ale
{
/// How far particles reach, beside what is known: subsections "Extent *".
class ParticleExtents
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads those of "Reference". @throws InputError for none of them
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Finds their regions. @throws InputError if there is none of a name
  void reinit(const std::vector<mpm::ParticleMaterial> &materials);

  bool empty() const
  {
    return extents_.empty();
  }

  /// extent_NAME [m], of cubes that deform as the particles do; 0 where none
  /// is. Collective.
  std::vector<NamedValue> values(const mpm::Particles &particles,
                                 const MPI_Comm communicator) const;

  /// Absolute relative errors extent_NAME [-]. Collective.
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

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/ale/exact/sphere_peaks.h>
#include <contrecoup/ale/particles/particle_extents.h>
#include <contrecoup/ale/particles/probe_displacements.h>
#include <contrecoup/base/expression.h>
#include <contrecoup/base/simulation.h>
#include <contrecoup/mpm/particle_material.h>
#include <contrecoup/mpm/particles.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace contrecoup::ale
{
/// The course of a front so far: numbers alone, for checkpoints.
struct FrontRecord
{
  double time = 0.;          ///< of the last step [s]
  double position = 0.;      ///< then [m]
  double error = 0.;         ///< sum of absolute errors at known times [m]
  double largest = 0.;       ///< of them [m]
  std::uint64_t n_known = 0; ///< times that have passed
};

/**
 * What a run of particles is compared with: the entries of subsection
 * "Reference", of which it declares "Expressions", "Front", "Extent *" and
 * "Probe displacements"; flows are those of meshes.
 */
class ParticleReference
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a solution that particles cannot be compared with
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Finds regions by their names. @throws InputError if there is none of its
  /// name, or if not as many displacements are known as there are probes
  void reinit(const std::vector<mpm::ParticleMaterial> &materials,
              const double half_spacing,
              const std::vector<dealii::Point<3>> &probes);

  /// What is compared, for histories: where the front and the far faces of
  /// extents are, displacements of probes. Collective.
  std::vector<NamedValue> history(const mpm::Particles &particles,
                                  const MPI_Comm communicator) const;

  /// Follows the front, and pressures at probes in a rigid sphere, after a step
  /// that ended at @p time. Collective.
  void follow(const std::vector<mpm::ParticleMaterial> &materials,
              const mpm::Particles &particles,
              const double time,
              const MPI_Comm communicator);

  /**
   * Mean absolute errors by undeformed volume: of expressions, of displacement,
   * velocity and pressure, at places at the start; of flows, of density,
   * velocity and pressure at present places; or of the front's places at the
   * known times that have passed; or relative ones of extents; or of probes'
   * displacements. Collective.
   */
  std::vector<NamedValue>
  errors(const std::vector<mpm::ParticleMaterial> &materials,
         const mpm::Particles &particles,
         const double time,
         const MPI_Comm communicator) const;

  /// Those that this rank has seen, by probe; for checkpoints.
  Peaks &peaks()
  {
    return peaks_;
  }

  /// For checkpoints.
  FrontRecord &record()
  {
    return record_;
  }

private:
  /// The farthest face of a region's particles along an axis.
  struct Front
  {
    std::string region;
    unsigned int material = 0, direction = 0;
    double half_spacing = 0.; ///< from a particle to its face [m]
    std::vector<double> times, positions;
  };

  /// Exact values, as far as they are given.
  struct Expressions
  {
    std::vector<Expression> displacement, velocity, pressure;
  };

  void follow_front(const mpm::Particles &particles,
                    const double time,
                    const MPI_Comm communicator);
  double front_position(const mpm::Particles &particles,
                        const MPI_Comm communicator) const;
  void parse_front(dealii::ParameterHandler &prm);

  double radius_ = 0.; ///< within which particles are compared [m]
  std::unique_ptr<ExactFlow> flow_;
  std::optional<Expressions> expressions_;
  std::optional<Front> front_;
  ParticleExtents extents_;
  std::unique_ptr<SpherePeaks> sphere_;
  std::unique_ptr<ProbeDisplacements> displacements_;
  FrontRecord record_;
  Peaks peaks_;
};
} // namespace contrecoup::ale

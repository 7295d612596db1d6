// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/ale/exact/sphere_peaks.h>
#include <contrecoup/ale/particles/particle_extents.h>
#include <contrecoup/ale/particles/particle_recorder.h>
#include <contrecoup/ale/particles/probe_displacements.h>
#include <contrecoup/base/parameters/expression.h>
#include <contrecoup/base/run/simulation.h>
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
/// Course of a material front. Plain data, written to checkpoints.
struct FrontRecord
{
  double time = 0.;          ///< of the last step [s]
  double position = 0.;      ///< at this time [m]
  double error = 0.;         ///< sum of absolute errors at the known times [m]
  double largest = 0.;       ///< largest absolute error [m]
  std::uint64_t n_known = 0; ///< number of known times that have passed
};

/**
 * The reference solution of a run with particles: subsection "Reference".
 * Declares "Expressions", "Front", "Extent *" and "Probe displacements";
 * ale::Reference declares the flows.
 */
class ParticleReference : public ParticleRecorder
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Warns of known times after the end time. @throws InputError for a solution
  /// that does not apply to particles, or that has no probes
  void parse_parameters(dealii::ParameterHandler &prm,
                        const ImpactScene &impact) override;

  /// Finds regions by name. @throws InputError for unknown names, or when the
  /// number of known displacements is not that of probes
  void reinit(const ParticleSnapshot &now) override;

  /// Compared quantities: position of the front, extents, displacements of
  /// probes.
  std::vector<NamedValue> history(const ParticleSnapshot &now) override;

  /// Updates the front, and peak pressures of probes in a rigid sphere.
  void record(const ParticleSnapshot &now) override;

  /**
   * Errors. Expressions: mean absolute errors, weighted with undeformed
   * volume, of displacement, velocity and pressure at initial positions;
   * flows: the same of density, velocity and pressure at present positions;
   * front: mean and largest absolute error of its position at known times that
   * have passed; extents: relative errors; probes: errors of displacement.
   */
  std::vector<NamedValue> errors(const ParticleSnapshot &now) const override;

  void save(io::StateWriter &out) const override
  {
    out.put(record_);
    out.put_list(peaks_);
  }
  void restore(const ParticleSnapshot & /*now*/, io::StateReader &in) override
  {
    in.take(record_);
    add_peaks(in, peaks_);
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

  /// Exact solutions; empty where not given.
  struct Expressions
  {
    std::vector<Expression> displacement, velocity, pressure;
  };

  void follow_front(const ParticleSnapshot &now);
  double front_position(const ParticleSnapshot &now) const;
  void parse_front(dealii::ParameterHandler &prm);
  void check_times(const double end_time) const;

  double radius_ = 0.; ///< particles are compared within this radius [m]
  std::optional<ExactFlow> flow_;
  std::optional<Expressions> expressions_;
  std::optional<Front> front_;
  ParticleExtents extents_;
  std::unique_ptr<SpherePeaks> sphere_;
  std::unique_ptr<ProbeDisplacements> displacements_;
  FrontRecord record_;
  Peaks peaks_;
};
} // namespace contrecoup::ale

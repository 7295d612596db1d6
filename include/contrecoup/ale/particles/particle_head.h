// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/head/head_record.h>
#include <contrecoup/mpm/particle_material.h>
#include <contrecoup/mpm/particles.h>

#include <vector>

namespace contrecoup::ale
{
/**
 * Records the injury measures of a head of particles. The peaks of a particle
 * of the brain move with it, in column::peak_strain, peak_pressure and
 * lowest_pressure.
 */
class ParticleHead : public HeadRecord
{
public:
  ParticleHead()
  {
    object_ = "particles";
  }

  /// Finds the centre of the brain at the start, from initial positions, after
  /// find(). Collective.
  void reinit(const mpm::Particles &particles, const MPI_Comm communicator);

  /// As the function of HeadRecord.
  std::string
  pressures_in_words(const std::vector<mpm::ParticleMaterial> &materials) const
  {
    return HeadRecord::pressures_in_words(brain_ != none &&
                                          materials[brain_].is_smoothed);
  }

  /// Takes the peaks from the particles, after restore().
  void resume(const mpm::Particles &particles);

  /// Call before the first step and after each step. Collective.
  void follow(const std::vector<mpm::ParticleMaterial> &materials,
              const double time,
              const MPI_Comm communicator,
              mpm::Particles &particles);

private:
  /// Calls @p work(block, particle) for the particles of the brain.
  template <typename Blocks, typename Work>
  void for_each_of_brain(Blocks &particles, const Work &work) const;
  void follow_brain(const mpm::ParticleMaterial &brain,
                    const double time,
                    mpm::Particles &particles);
  double height_of(const mpm::ParticleBlock &block,
                   const std::size_t particle) const;

  double centre_ = 0.; ///< height() of the brain's centre [m]
};
} // namespace contrecoup::ale

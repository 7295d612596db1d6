// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/particles/particle_recorder.h>
#include <contrecoup/ale/record/head_recorder.h>

#include <vector>

namespace contrecoup::ale
{
/**
 * Records the injury measures of a head of particles. The peaks of a particle
 * of the brain move with it, in column::peak_strain, peak_pressure and
 * lowest_pressure.
 */
class ParticleHead : public HeadRecorder<ParticleSnapshot>
{
public:
  ParticleHead()
  {
    object_ = "particles";
  }

  /// Finds the centre of the brain at the start, from initial positions, after
  /// find().
  void reinit(const ParticleSnapshot &now) override;

  /// As the function of HeadRecord.
  std::string
  pressures_in_words(const std::vector<mpm::ParticleMaterial> &materials) const
  {
    return HeadRecord::pressures_in_words(brain_ != none &&
                                          materials[brain_].is_smoothed);
  }

  void record(const ParticleSnapshot &now) override;
  void restore(const ParticleSnapshot &now, io::StateReader &in) override
  {
    restore_record(in, now.communicator);
    take_samples(now.particles);
  }

private:
  /// Takes volumes and peaks from the particles.
  void take_samples(const mpm::Particles &particles);
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

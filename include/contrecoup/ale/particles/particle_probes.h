// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/particles/particle_recorder.h>

namespace contrecoup::ale
{
/// Calls @p work(material, block, particle, probe) for each marked particle.
template <typename Work>
void for_each_probe(const mpm::Particles &particles, const Work &work)
{
  particles.for_each_block(
    [&](const unsigned int m, const mpm::ParticleBlock &block) {
      for (std::size_t p = 0; p < block.size(); ++p)
        if (const double mark = block[mpm::column::probe][p]; mark > 0.)
          work(m, block, p, static_cast<std::size_t>(mark) - 1);
    });
}

/// Marks the particle that is nearest to each probe at the start, in
/// column::probe, and reads it.
class ParticleProbes : public ParticleRecorder
{
public:
  void begin(const ParticleSnapshot &now) override;

  /// Pressure and density at each probe. Collective.
  static std::vector<NamedValue> values(const ParticleSnapshot &now);
};
} // namespace contrecoup::ale

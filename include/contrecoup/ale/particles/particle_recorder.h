// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/particles/particle_scene.h>
#include <contrecoup/ale/record/impact_recorder.h>
#include <contrecoup/mpm/particles.h>

#include <optional>

namespace contrecoup::ale
{
/// State of the particles at the end of a time step, as passed to the
/// recorders.
struct ParticleSnapshot : ImpactSnapshot
{
  const ParticleScene &scene;
  mpm::Particles &particles; ///< whose columns of probes and peaks may change
  /// Force between regions that may separate, of all ranks; nothing where none
  /// may [N].
  std::optional<double> region_force = {};
};

using ParticleRecorder = ImpactRecorder<ParticleSnapshot>;
} // namespace contrecoup::ale

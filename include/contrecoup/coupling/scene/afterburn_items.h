// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/coupling/scene/scene_layout.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// Items of a scene's plan about the energy that the products release in air,
/// and the largest rise of incident peak and impulse at the body by it.
std::vector<Assumption> afterburn_items(const SceneParameters &scene,
                                        const SceneLayout &layout);

/// Warning of an explosive of the user's own whose detonation has more energy
/// than the combustion of its Like, which stands for its own; else empty.
std::string warn_of_energy(const SceneParameters &scene);
} // namespace contrecoup::coupling

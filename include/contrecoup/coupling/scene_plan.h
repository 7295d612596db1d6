// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/coupling/scene_layout.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// What a scene takes for granted beyond what its blast does: symmetry, a
/// body that stands still for the gas, strain, gravity, and that the end time
/// is late enough; as expected from the layout alone.
/// @param body_mass [kg]
std::vector<Assumption> scene_plan(const SceneParameters &scene,
                                   const SceneLayout &layout,
                                   double body_mass);

/// What the stages found of these, and of what they took for granted
/// themselves; for stages without results nothing.
/// @param folder of the scene
std::vector<Assumption> scene_audit(const SceneParameters &scene,
                                    const SceneLayout &layout,
                                    const std::string &folder);

/// The plan of a stage, as its summary has it; empty without one.
std::vector<Assumption> stage_plan(const std::string &folder);
} // namespace contrecoup::coupling

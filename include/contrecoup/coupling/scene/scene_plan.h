// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/coupling/scene/scene_layout.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// Assumptions of a scene in addition to those of its blast, with estimates
/// from the layout alone: symmetry, a body at rest for the gas, small strain,
/// no gravity, a lung that the load does not crush, and a sufficient end time.
/// @param body_mass [kg]
std::vector<Assumption> scene_plan(const SceneParameters &scene,
                                   const SceneLayout &layout,
                                   double body_mass,
                                   bool has_lung);

/// Measured values of these assumptions and of those of the tasks; empty for
/// tasks without results.
/// @param folder of the scene
std::vector<Assumption> scene_audit(const SceneParameters &scene,
                                    const SceneLayout &layout,
                                    bool has_lung,
                                    const std::string &folder);

/// Plan of a task from its summary; empty without a summary.
std::vector<Assumption> task_plan(const std::string &folder);
} // namespace contrecoup::coupling

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/coupling/scene/chosen_side.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// Assumptions of a scene in addition to those of its blast, with estimates
/// from the layout alone: symmetry, sides of the domain that the user chose, a
/// body at rest for the gas, small strain, neither gravity nor ground for the
/// body, a lung that the load does not crush, and a sufficient end time.
/// @param wrote all assignments of the user
/// @param body_mass [kg]
std::vector<Assumption> scene_plan(const SceneParameters &scene,
                                   const SceneLayout &layout,
                                   const std::vector<Assignment> &wrote,
                                   double body_mass,
                                   bool has_lung);

/// Measured values of these assumptions and of those of the tasks; empty for
/// tasks without results; sides are where the plan has them.
/// @param plan scene_plan() of the scene
/// @param folder of the scene
std::vector<Assumption> scene_audit(const SceneParameters &scene,
                                    const SceneLayout &layout,
                                    const std::vector<Assumption> &plan,
                                    const std::string &folder);

/// Plan of the blast of a scene from its summary; empty without a summary.
/// @param folder of the scene
std::vector<Assumption> blast_plan(const std::string &folder);
} // namespace contrecoup::coupling

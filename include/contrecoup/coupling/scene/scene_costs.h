// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/collective.h>
#include <contrecoup/coupling/scene/planned_scene.h>
#include <contrecoup/coupling/task/scene_task.h>

#include <string>
#include <utility>
#include <vector>

namespace contrecoup::coupling
{
/// Names of stages with their cost estimates.
using StageCosts = std::vector<std::pair<std::string, CostEstimate>>;

/// Size of the report and of the scene's other files, 0 without a report
/// [byte]. Pictures have the size of those in measured reports: 4.0 and 2.9 MB
/// of a person, 1.9 and 1.2 MB of a head, with injuries and without.
double size_of_report(const PlannedScene &scene);

/// Cost estimates of the unfinished tasks and of the report, if it has a size.
/// Collective.
/// @param with_trials whether trial runs predict steps, time and output
/// @throws InputError unless the task that refuses its input is optional
StageCosts estimate_costs(std::vector<SceneTask> &tasks,
                          double report_bytes,
                          bool with_trials,
                          Collective &collective);
} // namespace contrecoup::coupling

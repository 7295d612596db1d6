// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/scene/planned_scene.h>
#include <contrecoup/coupling/task/scene_task.h>
#include <contrecoup/io/run/command_line.h>

namespace contrecoup::coupling
{
/// Logs the audit of a scene: measured values of the assumptions of scene and
/// blast, and a warning where the blast and the tables differ by more than
/// their errors. Warnings of the plan are not repeated.
void print_audit(const PlannedScene &scene,
                 const std::vector<SceneTask> &tasks,
                 const std::string &folder);

/// In @p warnings of a finished scene, replaces estimates that the scene has
/// measured otherwise, see io::replace_estimates().
void replace_estimates(const PlannedScene &scene,
                       const std::vector<SceneTask> &tasks,
                       const std::string &folder,
                       std::vector<std::string> &warnings);

/**
 * Writes scene.json: the scene, its tasks, plan and audit, as far as known.
 * @param reused names of the tasks whose results are reused
 * @param warnings of the scene itself, without those of its stages
 * @param n_ranks number of ranks of the run
 * @throws SystemError when the disk fails
 */
void write_scene(const PlannedScene &scene,
                 const std::vector<SceneTask> &tasks,
                 const std::vector<std::string> &reused,
                 const std::vector<std::string> &warnings,
                 const io::CommandLine &command,
                 unsigned int n_ranks);
} // namespace contrecoup::coupling

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/collective.h>
#include <contrecoup/coupling/scene/planned_scene.h>
#include <contrecoup/coupling/task/scene_task.h>
#include <contrecoup/io/run/command_line.h>

namespace contrecoup::coupling
{
/**
 * Creates the tasks of a scene in their order: anatomy, blast and, if injury
 * is asked for, biomechanics, then those of the coarser run, each with its
 * parameter file. Writes nothing.
 * @param prm entries of the scene
 * @param collective must outlive the tasks
 * @throws InputError for entries that an application does not have
 */
std::vector<SceneTask> make_tasks(const PlannedScene &scene,
                                  const io::CommandLine &command,
                                  const dealii::ParameterHandler &prm,
                                  Collective &collective);

/// Entries of the user that give a stage other values than it has without
/// them. @throws InputError as task_text()
std::vector<ChangedEntry> stage_changes(const PlannedScene &scene,
                                        const io::CommandLine &command,
                                        const dealii::ParameterHandler &prm,
                                        Collective &collective);

/// Shows which entries of the user have no effect on such a scene, gauges in
/// coarse cells and, unless the scene is @p about_to_run, whose blast does so,
/// a reflection from a side of the user's domain that is too near.
void warn_of_entries(const PlannedScene &scene,
                     const io::CommandLine &command,
                     const dealii::ParameterHandler &prm,
                     Collective &collective,
                     bool about_to_run = false);
} // namespace contrecoup::coupling

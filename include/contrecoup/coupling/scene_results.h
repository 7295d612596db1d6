// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/planned_scene.h>
#include <contrecoup/coupling/scene_stage.h>
#include <contrecoup/io/command_line.h>

namespace contrecoup::coupling
{
/// Logs what the stages in a scene's folder found of what it and its blast took
/// for granted.
void print_audit(const PlannedScene &scene, const std::string &folder);

/**
 * Writes scene.json: the scene, its stages, plan and audit, as far as they
 * are known.
 * @param reused names of the stages that had been finished before
 * @param n_ranks of the run
 * @throws SystemError when the disk fails
 */
void write_scene(const PlannedScene &scene,
                 const std::vector<SceneStage> &stages,
                 const std::vector<std::string> &reused,
                 const io::CommandLine &command,
                 unsigned int n_ranks);
} // namespace contrecoup::coupling

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/collective.h>
#include <contrecoup/coupling/scene/scene_costs.h>
#include <contrecoup/io/output/folder_claim.h>

#include <memory>
#include <optional>
#include <vector>

namespace contrecoup::coupling
{
/// Runs the tasks of one scene in its folder, on all ranks.
class SceneRun
{
public:
  /// Plans the scene and creates its tasks.
  /// @param prm entries of the scene, declared and parsed
  /// @throws InputError for an impossible scene
  SceneRun(const io::CommandLine &command,
           dealii::ParameterHandler &prm,
           Collective &collective);

  /// Prints the plan and the cost estimate of each task. Writes nothing.
  void check();

  /// Runs the tasks that are not finished and writes the report.
  /// @throws InputError, NumericsError, SystemError naming the task
  void execute();

private:
  StageCosts costs();
  /// Writes the forecast for other programs, see io::write_check_file().
  void write_forecast(const StageCosts &costs) const;
  /// Says which tasks a run has and what they cost.
  void show_stages(const StageCosts &costs) const;
  /// Checks all stages before the first one begins, with cost estimates if the
  /// scene wants them.
  void forecast();
  /// Whether the folder holds a scene and no other run.
  bool is_of_scene() const;
  /// Claims the output folder; returns false when nothing is left to do.
  bool claim();
  bool may_proceed() const;
  bool has_records() const;
  /// @throws InputError when results that must be kept would be removed
  void require_consent() const;
  std::string list_unfinished_tasks() const;
  void start();
  /// Outcome of a task: the failure is that of an optional one.
  struct TaskEnd
  {
    bool is_finished = false;
    Failure failure;
  };
  TaskEnd run(SceneTask &task);
  bool run_tasks();
  void run_all();
  /// Writes audit and report.
  void write_report();
  std::string path(const std::string &name) const
  {
    return command_.output_folder + "/" + name;
  }

  const io::CommandLine &command_;
  const dealii::ParameterHandler &prm_;
  Collective &collective_;
  bool is_first_rank_;
  std::optional<PlannedScene> scene_;
  std::vector<SceneTask> tasks_;
  std::vector<std::string> reused_;        ///< names of tasks
  std::unique_ptr<io::FolderClaim> claim_; ///< on the first rank only
};
} // namespace contrecoup::coupling

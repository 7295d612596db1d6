// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/collective.h>
#include <contrecoup/coupling/planned_scene.h>
#include <contrecoup/coupling/scene_stage.h>
#include <contrecoup/io/folder_claim.h>

#include <memory>
#include <optional>

namespace contrecoup::coupling
{
/// Runs the stages of one scene in its folder, on all ranks.
class SceneRun
{
public:
  /// Plans the scene and works out its stages.
  /// @param prm the scene's entries, declared and read
  /// @throws InputError for a scene that is not possible
  SceneRun(const io::CommandLine &command,
           dealii::ParameterHandler &prm,
           Collective &collective);

  /// Prints the plan and what each stage would cost. Writes nothing.
  void check();

  /// Runs what is not finished, and makes the report.
  /// @throws InputError, NumericsError, SystemError naming the stage
  void execute();

private:
  /// Prints what each stage that is not finished, and all of them together,
  /// would cost.
  void tell_costs();
  /// The same before a run.
  void forecast();
  /// Whether what is in the folder is a scene's, and no other run's.
  bool is_of_scene() const;
  /// Takes the folder; returns false when there is nothing to do in it.
  bool claim();
  bool admits() const;
  /// @throws InputError when results would go that are to be kept
  void require_consent() const;
  std::string told_stages() const;
  void start();
  bool run_stages();
  void run_all();
  /// Audit and report.
  void conclude();
  std::string path(const std::string &name) const
  {
    return command_.output_folder + "/" + name;
  }

  const io::CommandLine &command_;
  const dealii::ParameterHandler &prm_;
  Collective &collective_;
  bool is_first_rank_;
  std::optional<PlannedScene> scene_;
  std::vector<SceneStage> stages_;
  std::vector<std::string> reused_;        ///< names of stages
  std::unique_ptr<io::FolderClaim> claim_; ///< of the first rank
};
} // namespace contrecoup::coupling

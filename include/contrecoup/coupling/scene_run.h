// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/collective.h>
#include <contrecoup/base/parameter_file.h>
#include <contrecoup/base/simulation.h>
#include <contrecoup/coupling/scene_layout.h>
#include <contrecoup/coupling/scene_stage.h>
#include <contrecoup/coupling/tissue_places.h>
#include <contrecoup/geometry/body_description.h>
#include <contrecoup/io/application.h>
#include <contrecoup/io/command_line.h>

#include <optional>

namespace contrecoup::coupling
{
/// One scene in its folder, on all ranks.
class SceneRun
{
public:
  /// Works out the stages.
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
  void make_anatomy(const std::vector<Assignment> &wrote);
  void make_blast(const std::vector<Assignment> &wrote);
  void make_biomechanics(const std::vector<Assignment> &wrote);
  std::string text_of(const std::string &name,
                      const std::vector<Assignment> &entries,
                      const std::vector<Assignment> &wrote,
                      const io::ApplicationDescription &application) const;
  void print_plan();
  void print_audit();
  /// Of the scene and of its blast.
  std::vector<Assumption> whole_plan() const;
  /// Prints what each stage would cost.
  void forecast();
  void start();
  bool run_stages();
  void write_scene();
  void draw_report();
  std::string path(const std::string &name) const
  {
    return command_.output_folder + "/" + name;
  }

  const io::CommandLine &command_;
  const dealii::ParameterHandler &prm_;
  Collective &collective_;
  bool is_first_rank_;
  SceneParameters scene_;
  BodyDescription description_;
  BodyPointer body_;
  double body_mass_ = 0.; ///< [kg]
  std::optional<SceneLayout> layout_;
  std::vector<TissuePlace> places_;
  std::vector<SceneStage> stages_;
  std::vector<std::string> reused_; ///< names of stages
  std::vector<Assumption> plan_;
};
} // namespace contrecoup::coupling

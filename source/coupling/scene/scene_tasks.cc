// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/run/time_parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/memory.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/anatomy_application.h>
#include <contrecoup/coupling/application/biomechanics_application.h>
#include <contrecoup/coupling/application/blast_application.h>
#include <contrecoup/coupling/scene/coarser_run.h>
#include <contrecoup/coupling/scene/scene_checks.h>
#include <contrecoup/coupling/scene/scene_files.h>
#include <contrecoup/coupling/scene/scene_tasks.h>
#include <contrecoup/io/application/application.h>
#include <contrecoup/io/output/output_folder.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace contrecoup::coupling
{
using dealii::ParameterHandler;

namespace
{
  /// Runner of a solver.
  TaskDescription::Runner runner(const io::ApplicationDescription &application)
  {
    return [application](const std::vector<std::string> &arguments,
                         const double trial_share,
                         CostEstimate &cost) {
      forget_peak_memory();
      io::ApplicationDescription task = application;
      task.trial_share = trial_share;
      task.on_cost_estimate = [&cost](const CostEstimate &found) {
        cost = found;
      };
      return io::run_within(arguments, task);
    };
  }


  /// Runner of `anatomy`, which runs on the first rank.
  TaskDescription::Runner anatomy_runner(Collective &collective)
  {
    return [&collective](const std::vector<std::string> &arguments,
                         const double /*trial_share*/,
                         CostEstimate &cost) {
      forget_peak_memory();
      const io::ToolDescription tool = anatomy_application(
        [&cost](const CostEstimate &found) { cost = found; });
      Failure failure;
      try
      {
        collective.run([&]() {
          const bool works = dealii::Utilities::MPI::this_mpi_process(
                               collective.communicator()) == 0;
          const Failure own =
            works ? io::run_within(arguments, tool) : Failure();
          if (own.code != ExitCode::done)
            throw_failure(own);
        });
      }
      catch (...)
      {
        failure = to_failure(std::current_exception(), ExitCode::system_failed);
      }
      return failure;
    };
  }


  void declare(const io::ApplicationDescription &application,
               ParameterHandler &prm)
  {
    TimeParameters::declare_parameters(prm);
    application.declare_parameters(prm);
  }


  /// Arguments that load a body by the expected wave, for its forecast: fields
  /// of a body at rest would be compressed to nothing. A trace acts before, as
  /// recorded loads have one.
  std::vector<std::string> expected_load(const SceneLayout &layout)
  {
    const auto bounded = [](const double value, const double most) {
      return exact(std::isfinite(value) ? std::clamp(value, 1e-5, most) : most);
    };
    const dealii::Point<3> &charge = layout.charge;
    const std::string load = "Loads/Load expected/";
    std::vector<std::string> words = {"--set",
                                      "Loads/Load before/Pressure=1e-9"};
    for (const auto &[entry, value] :
         std::vector<std::pair<std::string, std::string>>{
           {"Kind", "friedlander"},
           {"Friedlander/Peak", bounded(layout.overpressure, 1e6)},
           {"Friedlander/Duration", bounded(layout.positive_phase, 1.)},
           {"Friedlander/Centre",
            exact(charge[0]) + "," + exact(charge[1]) + "," + exact(charge[2])},
           {"Friedlander/Speed",
            bounded(layout.distance / layout.arrival, 1e4)}})
    {
      words.emplace_back("--set");
      words.push_back(load + entry + "=" + value);
    }
    return words;
  }


  /// Creates the tasks from their common inputs.
  class Maker
  {
  public:
    Maker(const PlannedScene &scene,
          const io::CommandLine &command,
          const ParameterHandler &prm,
          Collective &collective)
      : scene_(scene)
      , folder_(command.output_folder)
      , prm_(prm)
      , wrote_(io::assignments_of(command, prm))
      , collective_(collective)
    {}

    SceneTask anatomy() const
    {
      const TaskText file = anatomy_text();
      return SceneTask({"anatomy",
                        "anatomy",
                        folder_,
                        file.text,
                        file.words,
                        anatomy_files(),
                        anatomy_runner(collective_)});
    }

    SceneTask blast() const
    {
      return SceneTask(blast("blast", {}));
    }

    SceneTask coarser_blast() const
    {
      TaskDescription task = blast("coarser_blast", CoarserRun::blast);
      task.is_optional = true;
      return SceneTask(task);
    }

    /// @throws InputError for contradictions between entries of stages
    void check() const
    {
      const TaskText blast = blast_text({});
      check_blast(scene_, blast);
      if (!scene_.parameters().wants_injury())
        return;
      require_loads();
      check_biomechanics(scene_, blast, biomechanics_text({}));
    }

    std::vector<ChangedEntry> changes() const
    {
      std::vector<ChangedEntry> all;
      for (const TaskText &text : texts())
        all.insert(all.end(), text.changes.begin(), text.changes.end());
      return all;
    }

    /// See warn_of_entries().
    void warn(const bool about_to_run) const
    {
      std::vector<Assignment> own;
      std::vector<std::string> of_biomechanics;
      const auto is_override = [](const Assignment &one) {
        return one.origin == "--set";
      };
      const bool chose_question =
        std::any_of(wrote_.begin(), wrote_.end(), [&](const Assignment &one) {
          return is_override(one) && one.entry == "Question";
        });
      for (const Assignment &assignment : wrote_)
        if (!SceneParameters::is_of_stage(assignment))
          own.push_back(assignment);
        else if (assignment.sections[0] == "Biomechanics" &&
                 !boost::algorithm::ends_with(assignment.origin,
                                              ", included") &&
                 (is_override(assignment) || !chose_question))
          of_biomechanics.push_back(join(assignment.sections, "/") + "/" +
                                    assignment.entry);
      std::vector<std::string> warnings = find_unused(prm_, own);
      if (!scene_.parameters().wants_injury() && !of_biomechanics.empty())
        warnings.push_back(unused_warning(
          of_biomechanics, "Scene/Question is loads, not injury"));
      const std::vector<TaskText> all = texts();
      for (const TaskText &text : all)
        warnings.insert(warnings.end(), text.unused.begin(), text.unused.end());
      std::vector<std::string> of_blast = {gauge_cells_warning(scene_, all[1]),
                                           grazing_warning(scene_)};
      if (!about_to_run)
        of_blast.push_back(reflection_warning(scene_, all[1]));
      for (const std::string &warning : of_blast)
        if (!warning.empty())
          warnings.push_back(warning);
      for (const std::string &warning : warnings)
        show_line(warning);
    }

    /// @param blast task that records the loads
    SceneTask biomechanics(const SceneTask &blast) const
    {
      return SceneTask(
        biomechanics("biomechanics", {}, blast.folder(), {blast.key()}));
    }

    /// @param blast coarser blast that records the loads
    /// @param finer biomechanics of the scene
    SceneTask coarser_biomechanics(const SceneTask &blast,
                                   const SceneTask &finer) const
    {
      TaskDescription task = biomechanics("coarser_biomechanics",
                                          CoarserRun::biomechanics,
                                          blast.folder(),
                                          {blast.key(), finer.key()});
      task.is_optional = true;
      task.find_late_arguments = [folder = finer.folder()]() {
        return CoarserRun::same_correction_of_loads(folder);
      };
      return SceneTask(task);
    }

  private:
    /// Texts of anatomy, blast and, if injury is asked for, biomechanics.
    std::vector<TaskText> texts() const
    {
      std::vector<TaskText> texts{anatomy_text(), blast_text({})};
      if (scene_.parameters().wants_injury())
        texts.push_back(biomechanics_text({}));
      return texts;
    }

    /// @throws InputError unless the blast records the loads for biomechanics
    void require_loads() const
    {
      for (const Assignment &assignment : wrote_)
        if (join(assignment.sections, "/") == "Blast/Loads" &&
            assignment.entry == "Record" && assignment.value == "false")
          throw InputError(assignment.origin +
                           ": Blast/Loads/Record must be true, for stage "
                           "biomechanics takes the loads; Scene/Question = "
                           "loads leaves this stage out");
    }

    TaskText anatomy_text() const
    {
      return task_text("Anatomy",
                       anatomy_entries(scene_.parameters()),
                       prm_,
                       wrote_,
                       anatomy_application().declare_parameters);
    }

    TaskText blast_text(const EntryChanges &changes) const
    {
      TaskText text =
        text_of("Blast",
                blast_application(),
                blast_entries(
                  scene_.parameters(), scene_.layout(), scene_.person_mass()),
                changes);
      // A later end needs the domain that the scene chooses.
      for (const Assignment &assignment : wrote_)
        if (join(assignment.sections, "/") == "Blast/Domain" &&
            assignment.entry.find(" corner") != std::string::npos)
          text.words.rename("Domain/Size",
                            "the corners of Blast/Domain, which the scene "
                            "chooses if they are left out");
      return text;
    }

    TaskText biomechanics_text(const EntryChanges &changes) const
    {
      return text_of("Biomechanics",
                     biomechanics_application(),
                     biomechanics_entries(scene_.parameters(),
                                          scene_.layout(),
                                          scene_.body(),
                                          scene_.tissue_places(),
                                          scene_.person_mass()),
                     changes,
                     {parse_override("Loads/Recorded/File=of the blast")});
    }

    TaskDescription blast(const std::string &name,
                          const EntryChanges &changes) const
    {
      return solver(name, blast_application(), blast_text(changes), {});
    }

    TaskDescription biomechanics(const std::string &name,
                                 const EntryChanges &changes,
                                 const std::string &blast,
                                 const std::vector<std::string> &upstream) const
    {
      TaskDescription task = solver(
        name, biomechanics_application(), biomechanics_text(changes), upstream);
      const std::filesystem::path folder = std::filesystem::absolute(blast);
      task.arguments = {
        "--set", "Loads/Recorded/File=" + (folder / "loads.h5").string()};
      task.check_arguments = expected_load(scene_.layout());
      task.words.rename("Loads/Recorded/File",
                        "the loads of stage " + folder.filename().string());
      return task;
    }

    TaskText text_of(const std::string &section,
                     const io::ApplicationDescription &application,
                     const std::vector<Assignment> &entries,
                     const EntryChanges &changes,
                     const std::vector<Assignment> &given = {}) const
    {
      return task_text(
        section,
        entries,
        prm_,
        wrote_,
        [&](ParameterHandler &prm) { declare(application, prm); },
        changes,
        given);
    }

    TaskDescription solver(const std::string &name,
                           const io::ApplicationDescription &application,
                           const TaskText &file,
                           const std::vector<std::string> &upstream) const
    {
      ParameterHandler defaults, prm;
      declare(application, defaults);
      declare(application, prm);
      apply_assignments(file.entries, prm);
      return {name,
              application.name,
              folder_,
              file.text,
              file.words,
              io::OutputFolder::run_files() + application.files(defaults),
              runner(application),
              upstream,
              application.tables(prm),
              true};
    }

    const PlannedScene &scene_;
    std::string folder_;
    const ParameterHandler &prm_;
    std::vector<Assignment> wrote_;
    Collective &collective_;
  };
} // namespace


std::vector<SceneTask> make_tasks(const PlannedScene &scene,
                                  const io::CommandLine &command,
                                  const ParameterHandler &prm,
                                  Collective &collective)
{
  const Maker maker(scene, command, prm, collective);
  maker.check();
  std::vector<SceneTask> tasks{maker.anatomy(), maker.blast()};
  if (scene.parameters().wants_injury())
    tasks.push_back(maker.biomechanics(tasks.back()));
  if (!scene.parameters().estimates_error)
    return tasks;
  const SceneTask finer = tasks.back();
  tasks.push_back(maker.coarser_blast());
  // Hexahedra of one's own have no larger ones.
  if (scene.parameters().wants_injury() && !scene.body().own_mesh())
    tasks.push_back(maker.coarser_biomechanics(tasks.back(), finer));
  return tasks;
}


std::vector<ChangedEntry> stage_changes(const PlannedScene &scene,
                                        const io::CommandLine &command,
                                        const ParameterHandler &prm,
                                        Collective &collective)
{
  return Maker(scene, command, prm, collective).changes();
}


void warn_of_entries(const PlannedScene &scene,
                     const io::CommandLine &command,
                     const ParameterHandler &prm,
                     Collective &collective,
                     const bool about_to_run)
{
  Maker(scene, command, prm, collective).warn(about_to_run);
}
} // namespace contrecoup::coupling

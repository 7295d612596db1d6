// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/log.h>
#include <contrecoup/base/memory.h>
#include <contrecoup/base/parameter_tree.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/base/text.h>
#include <contrecoup/base/time_parameters.h>
#include <contrecoup/base/version.h>
#include <contrecoup/coupling/anatomy_application.h>
#include <contrecoup/coupling/biomechanics_application.h>
#include <contrecoup/coupling/blast_application.h>
#include <contrecoup/coupling/scene_files.h>
#include <contrecoup/coupling/scene_plan.h>
#include <contrecoup/coupling/scene_run.h>
#include <contrecoup/io/checked_file.h>

#include <filesystem>

namespace contrecoup::coupling
{
using dealii::ParameterHandler;

namespace
{
  /// A solver as a stage.
  SceneStage::Runner runner(const io::ApplicationDescription &application)
  {
    return [application](const std::vector<std::string> &arguments) {
      forget_peak_memory();
      return io::run_within(arguments, application);
    };
  }


  /// A tool as a stage: the first rank's work.
  SceneStage::Runner runner(const io::ToolDescription &tool,
                            Collective &collective)
  {
    return [tool, &collective](const std::vector<std::string> &arguments) {
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


  std::vector<Assignment> assignments_of(const io::CommandLine &command)
  {
    std::vector<Assignment> wrote = read_assignments(command.parameter_file);
    for (const std::string &text : command.overrides)
      wrote.push_back(parse_override(text));
    return wrote;
  }


  void declare(const io::ApplicationDescription &application,
               ParameterHandler &prm)
  {
    TimeParameters::declare_parameters(prm);
    application.declare_parameters(prm);
  }
} // namespace


SceneRun::SceneRun(const io::CommandLine &command,
                   ParameterHandler &prm,
                   Collective &collective)
  : command_(command)
  , prm_(prm)
  , collective_(collective)
  , is_first_rank_(
      dealii::Utilities::MPI::this_mpi_process(collective.communicator()) == 0)
{
  collective_.run(
    [&]() {
      scene_.parse_parameters(prm);
      {
        const Section section(prm, "Body");
        description_.parse_parameters(prm);
      }
      body_ = description_.create();
      layout_.emplace(scene_, *body_->surface());
      body_mass_ = description_.kind() == "phantom"
                     ? description_.reference_mass()
                     : estimate_mass(*body_, scene_.accuracy.element_size);
      if (scene_.wants_injury())
        places_ = find_tissue_places(
          *body_, layout_->charge, scene_.accuracy.element_size);
      const auto wrote = assignments_of(command_);
      make_anatomy(wrote);
      make_blast(wrote);
      if (scene_.wants_injury())
        make_biomechanics(wrote);
      plan_ = scene_plan(scene_, *layout_, body_mass_);
    },
    ExitCode::bad_input);
}


std::string
SceneRun::text_of(const std::string &name,
                  const std::vector<Assignment> &entries,
                  const std::vector<Assignment> &wrote,
                  const io::ApplicationDescription &application) const
{
  return stage_text(name, entries, prm_, wrote, [&](ParameterHandler &prm) {
    declare(application, prm);
  });
}


void SceneRun::make_anatomy(const std::vector<Assignment> &wrote)
{
  const io::ToolDescription tool = anatomy_application();
  stages_.emplace_back(
    "anatomy",
    command_.output_folder,
    stage_text(
      "Anatomy", anatomy_entries(scene_), prm_, wrote, tool.declare_parameters),
    std::vector<std::string>(),
    false,
    runner(tool, collective_));
}


void SceneRun::make_blast(const std::vector<Assignment> &wrote)
{
  const auto application = blast_application();
  stages_.emplace_back(
    "blast",
    command_.output_folder,
    text_of("Blast", blast_entries(scene_, *layout_), wrote, application),
    std::vector<std::string>(),
    true,
    runner(application));
}


void SceneRun::make_biomechanics(const std::vector<Assignment> &wrote)
{
  const auto application = biomechanics_application();
  const auto entries =
    biomechanics_entries(scene_, *layout_, *body_, places_, body_mass_);
  stages_.emplace_back("biomechanics",
                       command_.output_folder,
                       text_of("Biomechanics", entries, wrote, application),
                       std::vector<std::string>{stages_.back().key()},
                       true,
                       runner(application));
  const std::string loads =
    std::filesystem::absolute(path("blast/loads.h5")).string();
  stages_.back().set_arguments({"--set", "Loads/Recorded/File=" + loads});
}


void SceneRun::check()
{
  print_plan();
  for (SceneStage &stage : stages_)
    if (stage.is_finished())
      log_line("stage " + stage.name() + " is finished in " + stage.folder());
    else
      stage.check(collective_);
}


void SceneRun::forecast()
{
  // The checks of stages close it, but there may be none.
  Log::instance().close();
  for (SceneStage &stage : stages_)
    if (!stage.is_finished())
      stage.check(collective_);
  collective_.run([&]() { Log::instance().open(path("log.txt"), true); });
}


void SceneRun::start()
{
  collective_.run([&]() {
    if (command_.resume)
    {
      bool any = false;
      for (const SceneStage &stage : stages_)
        any = any || stage.has_record();
      if (!any)
        throw InputError("--resume: \"" + command_.output_folder +
                         "\" holds no stage of a scene");
    }
  });
  collective_.run([&]() {
    if (!is_first_rank_)
      return;
    std::error_code error;
    std::filesystem::create_directories(command_.output_folder, error);
    if (error)
      throw InputError("cannot make the output folder \"" +
                       command_.output_folder + "\": " + error.message());
    io::write_file(path("parameters.prm"), [&](std::ostream &out) {
      out << "# scene " << version() << " (" << git_revision()
          << "): every entry as used\n\n"
          << parameter_text(prm_, false);
    });
    Log::instance().open(path("log.txt"), command_.resume);
  });
}


bool SceneRun::run_stages()
{
  for (SceneStage &stage : stages_)
  {
    if (stage.is_finished())
    {
      log_line("stage " + stage.name() + ": finished before, taken from " +
               stage.folder());
      reused_.push_back(stage.name());
      continue;
    }
    log_line("stage " + stage.name() + ":");
    Log::instance().close();
    const bool finished = stage.run(command_.resume, collective_);
    collective_.run([&]() { Log::instance().open(path("log.txt"), true); });
    if (!finished)
    {
      log_line("stopped in stage " + stage.name() +
               "; --resume goes on from there");
      return false;
    }
    const StageRecord &record = stage.record();
    log_line("stage " + stage.name() + " took " +
             duration(record.wall_seconds) + ", " + bytes(record.peak_memory) +
             " of memory, " + bytes(record.disk) + " on disk");
  }
  return true;
}


void SceneRun::execute()
{
  start();
  print_plan();
  if (scene_.has_forecast && !command_.resume)
    forecast();
  const bool finished = run_stages();
  collective_.run([&]() {
    if (is_first_rank_)
      write_scene();
  });
  if (!finished)
    return;
  collective_.run([&]() {
    if (!is_first_rank_)
      return;
    print_audit();
    if (scene_.draws_report)
      draw_report();
    log_line("results in " + command_.output_folder);
    Log::instance().check();
  });
}
} // namespace contrecoup::coupling

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/log.h>
#include <contrecoup/base/parameter_tree.h>
#include <contrecoup/base/text.h>
#include <contrecoup/base/version.h>
#include <contrecoup/coupling/scene_results.h>
#include <contrecoup/coupling/scene_run.h>
#include <contrecoup/coupling/scene_stages.h>
#include <contrecoup/io/checked_file.h>
#include <contrecoup/io/pictures.h>

#include <filesystem>

namespace contrecoup::coupling
{
SceneRun::SceneRun(const io::CommandLine &command,
                   dealii::ParameterHandler &prm,
                   Collective &collective)
  : command_(command)
  , prm_(prm)
  , collective_(collective)
  , is_first_rank_(
      dealii::Utilities::MPI::this_mpi_process(collective.communicator()) == 0)
{
  collective_.run(
    [&]() {
      scene_.emplace(prm);
      stages_ = make_stages(*scene_, command_, prm, collective_);
    },
    ExitCode::bad_input);
}


void SceneRun::check()
{
  scene_->print();
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
  scene_->print();
  if (scene_->parameters().has_forecast && !command_.resume)
    forecast();
  const bool finished = run_stages();
  collective_.run([&]() {
    if (is_first_rank_)
      write_scene(
        *scene_,
        stages_,
        reused_,
        command_,
        dealii::Utilities::MPI::n_mpi_processes(collective_.communicator()));
  });
  if (finished)
    collective_.run([&]() {
      if (is_first_rank_)
        conclude();
    });
}


void SceneRun::conclude()
{
  print_audit(*scene_, command_.output_folder);
  if (scene_->parameters().draws_report)
    io::draw("report.py", command_.output_folder, "report", "report.html");
  log_line("results in " + command_.output_folder);
  Log::instance().check();
}
} // namespace contrecoup::coupling

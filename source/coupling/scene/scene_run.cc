// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/coupling/scene/scene_files.h>
#include <contrecoup/coupling/scene/scene_results.h>
#include <contrecoup/coupling/scene/scene_run.h>
#include <contrecoup/coupling/scene/scene_tasks.h>
#include <contrecoup/io/application/check_file.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/output/pictures.h>
#include <contrecoup/io/run/plan_table.h>

#include <algorithm>

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
      scene_.emplace(prm, io::assignments_of(command_, prm));
      tasks_ = make_tasks(*scene_, command_, prm, collective_);
      scene_->add_changes(stage_changes(*scene_, command_, prm, collective_));
    },
    ExitCode::bad_input);
}


namespace
{
  /// Suppresses the log while it exists.
  class Silence
  {
  public:
    explicit Silence(const bool was_active)
      : was_active_(was_active)
    {
      Log::instance().set_active(false);
    }
    ~Silence()
    {
      Log::instance().set_active(was_active_);
    }
    Silence(const Silence &) = delete;
    Silence &operator=(const Silence &) = delete;

  private:
    bool was_active_;
  };
} // namespace


StageCosts SceneRun::costs()
{
  return estimate_costs(tasks_,
                        size_of_report(*scene_),
                        scene_->parameters().has_forecast,
                        collective_);
}


void SceneRun::write_forecast(const StageCosts &costs) const
{
  io::CheckReport report{
    "scene", io::total_of(costs), {"scene.json:*", "report.json:*"}, costs};
  for (const SceneTask &task : tasks_)
  {
    std::vector<std::string> outputs =
      io::file_outputs(task.description().files, task.description().tables);
    const std::vector<std::string> of_summary =
      task.name() == "anatomy" ? std::vector<std::string>{"*"}
                               : io::summary_outputs();
    outputs.insert(outputs.end(), of_summary.begin(), of_summary.end());
    for (const std::string &output : outputs)
      report.outputs.push_back(task.name() + "/" + output);
  }
  io::write_check_file(report);
}


void SceneRun::check()
{
  scene_->print(true);
  for (const std::string &line : scene_->uncertain_layers())
    show_line(line);
  warn_of_entries(*scene_, command_, prm_, collective_);
  for (SceneTask &task : tasks_)
    task.inspect(collective_);
  for (const SceneTask &task : tasks_)
    if (task.is_finished())
      show_line("stage " + task.name() + " is finished in " + task.folder());
  const StageCosts rows = costs();
  collective_.run([&]() {
    if (is_first_rank_)
      write_forecast(rows);
  });
  if (rows.empty())
    return;
  const unsigned int ranks =
    dealii::Utilities::MPI::n_mpi_processes(collective_.communicator());
  show_line("scene would run " + command_.parameter_file + " on " +
            io::counted_ranks(ranks) + " stage by stage, with output in " +
            command_.output_folder + ":");
  for (const std::string &line : io::cost_lines(rows))
    show_line(line);
  show_line("The parameters are valid.");
}


void SceneRun::show_stages(const StageCosts &costs) const
{
  const CostEstimate total = io::total_of(costs);
  std::vector<std::string> names;
  for (const SceneTask &task : tasks_)
    names.push_back(task.name() +
                    (task.is_finished() ? " (finished before)" : ""));
  std::vector<std::string> known;
  if (total.seconds > 0.)
    known.push_back("about " + duration(total.seconds));
  if (total.memory > 0.)
    known.push_back(bytes(total.memory) + " of memory");
  if (total.output > 0.)
    known.push_back(bytes(total.output) + " on disk");
  show_line("  stages: " + join(names, ", ") +
            (known.empty() ? "" : "; " + join(known, ", ")));
}


void SceneRun::forecast()
{
  if (scene_->parameters().has_forecast)
  {
    show_stages(costs());
    return;
  }
  show_stages({});
  const LogPart part;
  // A refusal by a later stage is better known before the first one.
  const Silence silence(is_first_rank_);
  for (SceneTask &task : tasks_)
    if (!task.is_finished() && !task.description().is_optional)
      task.check(0., collective_);
}


bool SceneRun::claim()
{
  collective_.run([&]() {
    if (!is_first_rank_)
      return;
    io::FileNames names = {{"parameters.prm", "scene.json"},
                           {"log.txt",
                            "report.html",
                            "report.html.new",
                            "report.json",
                            "report.json.new",
                            "headline.txt",
                            "headline.txt.new"}};
    for (const SceneTask &task : tasks_)
      names = names + TaskFiles::names(task.name());
    claim_ = std::make_unique<io::FolderClaim>(
      command_.output_folder,
      "scene",
      names,
      io::make_run_input(parameter_values(prm_)));
    for (const SceneTask &task : tasks_)
      task.prepare();
  });
  for (SceneTask &task : tasks_)
    task.inspect(collective_);
  const unsigned int may_run = collective_.run_with_flags(
    [&]() { return is_first_rank_ && may_proceed() ? 1U : 0U; });
  return may_run != 0;
}


std::string SceneRun::list_unfinished_tasks() const
{
  std::vector<std::string> kept, replaced;
  for (const SceneTask &task : tasks_)
    (task.is_finished() ? kept : replaced).push_back(task.name());
  std::vector<std::string> does;
  if (!replaced.empty())
    does.push_back("makes " + join(replaced, ", ") + " anew");
  if (!kept.empty())
    does.push_back("takes " + join(kept, ", ") +
                   (kept.size() > 1 ? " as they are" : " as it is"));
  return join(does, " and ");
}


void SceneRun::require_consent() const
{
  const std::string here = "\"" + command_.output_folder + "\" holds ";
  const std::string changed = claim_->difference();
  const std::string what = claim_->manifest().status() == "finished"
                             ? "the results of another scene"
                             : "finished stages of another scene";
  for (const SceneTask &task : tasks_)
    if (task.status().has_other_key && !changed.empty())
      throw InputError(here + what + ": " + changed + "; --overwrite " +
                       list_unfinished_tasks() + ", or give another --output");
  // Starting again would lose the computed part.
  for (const SceneTask &task : tasks_)
    if (command_.resume && task.status().has_checkpoint &&
        !task.status().is_started && !task.is_finished())
      throw InputError(
        here + "a checkpoint of stage " + task.name() + " from which " +
        (changed.empty() ? "this build or these input files cannot continue"
                         : "this scene cannot continue: " + changed) +
        "; --overwrite begins that stage anew");
  if (command_.resume)
    return;
  if (claim_->manifest().status() == "finished" && !changed.empty())
    throw InputError(here + what + ": " + changed +
                     "; --overwrite renews what depends on that, or give "
                     "another --output");
  for (const SceneTask &task : tasks_)
    if (task.status().has_checkpoint)
      throw InputError(here + "a scene that has not finished (stage " +
                       task.name() +
                       "); --resume goes on with it, --overwrite begins "
                       "that stage anew");
}


bool SceneRun::is_of_scene() const
{
  return claim_->manifest().application() == "scene";
}


bool SceneRun::has_records() const
{
  return std::any_of(tasks_.begin(), tasks_.end(), [](const SceneTask &task) {
    return task.status().has_record;
  });
}


bool SceneRun::may_proceed() const
{
  if (claim_->goes_on(command_, has_records()) && !has_records())
    throw InputError("--resume: \"" + command_.output_folder +
                     "\" holds no stage of a scene");
  const io::Manifest &manifest = claim_->manifest();
  if (!manifest.exists() || command_.overwrite)
    return true;
  if (!is_of_scene())
    throw InputError("\"" + command_.output_folder + "\" holds a run of \"" +
                     manifest.application() + "\" (" + manifest.status() +
                     "); --overwrite replaces it, or give another --output");
  require_consent();
  if (manifest.status() != "finished" || !claim_->difference().empty() ||
      !manifest.damage().empty())
    return true;
  std::string others;
  for (const SceneTask &task : tasks_)
  {
    if (!task.is_finished() && !task.status().has_other_key)
      return true;
    if (task.status().has_other_key)
      others += " (" + task.name() + " by another build)";
  }
  if (command_.resume && others.empty())
    return true;
  show_line("finished before, nothing is done: \"" + command_.output_folder +
            "\" holds the results" + others +
            "; --resume makes the report again, --overwrite computes all anew");
  return false;
}


void SceneRun::start()
{
  // --overwrite of an unchanged finished scene runs all tasks again.
  const unsigned int anew = collective_.run_with_flags([&]() {
    return is_first_rank_ && command_.overwrite &&
               claim_->manifest().status() == "finished" &&
               claim_->difference().empty()
             ? 1U
             : 0U;
  });
  for (SceneTask &task : tasks_)
    if (anew != 0 && task.is_finished())
      task.discard_result();
  collective_.run([&]() {
    if (!is_first_rank_)
      return;
    if (claim_->manifest().exists() && !is_of_scene())
      // The folder holds another run without files of tasks.
      claim_->begin();
    else
    {
      if (command_.overwrite && claim_->manifest().exists())
      {
        const std::string words = list_unfinished_tasks();
        show_line("--overwrite " + words +
                  (begins_with(words, "makes")
                     ? "; what was there before goes when the new is complete"
                     : ""));
      }
      claim_->resume();
    }
    io::write_file(path("parameters.prm"), [&](std::ostream &out) {
      out << "# scene " << version() << " (" << git_revision()
          << "): the entries that make this scene\n\n"
          << scene_text(prm_, io::assignments_of(command_, prm_));
    });
    Log::instance().open(path("log.txt"), command_.resume);
  });
}


SceneRun::TaskEnd SceneRun::run(SceneTask &task)
{
  const LogPart part(task.name(), task.description().is_optional);
  Log::instance().status("begins");
  TaskEnd end;
  try
  {
    end.is_finished = task.run(command_.resume, collective_);
  }
  catch (const InputError &)
  {
    if (!task.description().is_optional)
      throw;
    end.failure = to_failure(std::current_exception(), ExitCode::bad_input);
  }
  catch (const NumericsError &)
  {
    if (!task.description().is_optional)
      throw;
    end.failure =
      to_failure(std::current_exception(), ExitCode::numerics_failed);
  }
  return end;
}


bool SceneRun::run_tasks()
{
  for (SceneTask &task : tasks_)
  {
    if (task.is_finished())
    {
      log_line("stage " + task.name() + ": finished before, taken from " +
               task.folder());
      reused_.push_back(task.name());
      continue;
    }
    log_line("stage " + task.name() +
             (task.description().is_optional
                ? ", for the estimate of the error alone:"
                : ":"));
    const TaskEnd end = run(task);
    if (end.failure.code != ExitCode::done)
    {
      log_line("WARNING: no estimate of the numerical error: " +
               end.failure.message);
      break;
    }
    if (!end.is_finished)
    {
      show_line("stopped in stage " + task.name() +
                "; --resume goes on from there");
      return false;
    }
    const TaskRecord &record = task.record();
    const std::string took = "stage " + task.name() + " took " +
                             duration(record.wall_seconds) + ", " +
                             bytes(record.peak_memory) + " of memory, " +
                             bytes(record.disk) + " on disk";
    task.description().is_optional ? log_line(took) : show_line(took);
  }
  return true;
}


void SceneRun::execute()
{
  if (!claim())
    return;
  start();
  try
  {
    run_all();
  }
  catch (const std::exception &)
  {
    const Failure failure =
      to_failure(std::current_exception(), ExitCode::system_failed);
    try
    {
      collective_.run([&]() {
        if (is_first_rank_)
          claim_->set_status(is_stop(failure) ? "stopped" : "failed");
      });
    }
    catch (const std::exception &)
    {
      // The first failure is reported.
    }
    throw;
  }
}


void SceneRun::run_all()
{
  scene_->print(false);
  warn_of_entries(*scene_, command_, prm_, collective_, true);
  std::vector<std::string> warnings = Log::instance().warnings();
  if (!command_.resume || !has_records())
    try
    {
      forecast();
    }
    catch (const Stopped &)
    {
      show_line("stopped in the forecast, before the first stage; the same "
                "command begins anew");
      throw;
    }
  const bool finished = run_tasks();
  collective_.run([&]() {
    if (!is_first_rank_)
      return;
    if (finished)
      print_audit(*scene_, tasks_, command_.output_folder);
    for (const std::string &warning : Log::instance().warnings())
      if (std::find(warnings.begin(), warnings.end(), warning) ==
          warnings.end())
        warnings.push_back(warning);
    if (finished)
      replace_estimates(*scene_, tasks_, command_.output_folder, warnings);
    write_scene(
      *scene_,
      tasks_,
      reused_,
      warnings,
      command_,
      dealii::Utilities::MPI::n_mpi_processes(collective_.communicator()));
  });
  for (const SceneTask &task : tasks_)
    if (is_stop(task.stop()))
      throw_failure(task.stop());
  collective_.run([&]() {
    if (!is_first_rank_)
      return;
    if (finished)
      write_report();
    claim_->set_status(finished ? "finished" : "stopped");
  });
}


void SceneRun::write_report()
{
  const bool is_missing =
    scene_->parameters().draws_report &&
    !io::draw("report", command_.output_folder, "report", "report.html");
  show_line("results in " + command_.output_folder);
  Log::instance().check();
  if (is_missing && SignalGuard::stop_signal() != 0)
  {
    show_line("stopped while the report was drawn; --resume makes it");
    SignalGuard::require_no_stop();
  }
  if (is_missing)
    throw SystemError("all stages are finished, but there is no report; "
                      "--resume makes it again");
}
} // namespace contrecoup::coupling

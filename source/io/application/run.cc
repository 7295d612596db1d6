// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/memory.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/io/application/check_file.h>
#include <contrecoup/io/application/cost_forecast.h>
#include <contrecoup/io/application/run.h>
#include <contrecoup/io/application/trial_limits.h>
#include <contrecoup/io/output/pictures.h>
#include <contrecoup/io/output/summary.h>
#include <contrecoup/io/run/plan_table.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Entries of the run loop that may differ on --resume.
    const std::vector<std::string> free_entries = {
      "Time/End time",
      "Time/Largest number of steps",
      "Time/Steps in this run",
      "Time/Minutes in this run",
      "Output/"};

    TimeParameters parse_time(dealii::ParameterHandler &prm)
    {
      TimeParameters parameters;
      parameters.parse_parameters(prm);
      return parameters;
    }

    /// Reason for stopping; empty without a signal.
    std::string told_stop(const int signal)
    {
      return signal == 0 ? ""
                         : std::string(Stopped(signal).what()) +
                             "; --resume goes on from here";
    }
  } // namespace

  Run::Run(const CommandLine &command,
           const ApplicationDescription &description,
           dealii::ParameterHandler &prm,
           Simulation &simulation,
           Collective &collective)
    : command_(command)
    , description_(description)
    , prm_(prm)
    , parameter_text_("# " + description.name + " " + version() + " (" +
                      git_revision() + "): every entry as used\n\n" +
                      parameter_text(prm, false))
    , time_(parse_time(prm))
    , simulation_(simulation)
    , collective_(collective)
    , folder_(command.output_folder,
              description.name,
              parameter_values(prm),
              description.files ? description.files(prm) : FileNames(),
              collective)
  {}

  CostEstimate Run::estimate()
  {
    CostEstimate cost;
    collective_.run([&]() { cost = simulation_.estimate(); },
                    ExitCode::bad_input);
    const double available = available_memory(collective_.communicator());
    if (available > 0. && cost.memory > available)
      throw InputError("a mesh of " + brief(cost.cells) + " cells needs " +
                       bytes(cost.memory) + " of memory, this machine has " +
                       bytes(available) + " left");
    return cost;
  }

  namespace
  {
    /// Takes the @p known steps of a body at rest, if they are not those of the
    /// @p rough estimate.
    void correct_steps(const double known,
                       const double rough,
                       const TimeParameters &time,
                       TriedCost &cost)
    {
      if (known == rough)
        return;
      double steps = known;
      if (time.largest_step > 0.)
        steps = std::max(steps, time.end_time / time.largest_step);
      if (time.largest_number_of_steps > 0)
        steps =
          std::min(steps, static_cast<double>(time.largest_number_of_steps));
      steps = std::round(steps);
      cost.seconds *= cost.steps > 0. ? steps / cost.steps : 1.;
      cost.steps = steps;
    }

    /// Why steps are not known without the run itself; empty: they are.
    std::string gap_of_steps(const ApplicationDescription &description,
                             const dealii::ParameterHandler &prm,
                             const TriedCost &cost)
    {
      // Finer elements deform more, and need still more steps.
      constexpr double largest_growth = 1.03;
      if (description.keeps_first_step && cost.step_growth > largest_growth)
        return "as it deforms, the coarser body of the trial runs needs " +
               brief(cost.step_growth, 3) + " times as many steps as at rest";
      if (description.strikes && description.strikes(prm))
        return "how much the body deforms when it strikes the ground, coarser "
               "trial runs do not show";
      return "";
    }

    /// Why trial runs leave figures unknown, where they do.
    std::string gap_of_trials(const ApplicationDescription &description)
    {
      const double budget = description.trial_share * trial_seconds();
      return budget > 0. ? "trial runs of some " + brief(budget) +
                             " s do not tell; CONTRECOUP_CHECK_SECONDS gives "
                             "them longer"
                         : "no trial runs were asked for";
    }
  } // namespace

  void Run::check()
  {
    const CostEstimate rough = estimate();
    TriedCost cost =
      cached_or_forecast_cost(description_, prm_, rough, collective_);
    CostEstimate known = rough;
    collective_.run([&]() {
      plan_ = simulation_.plan();
      // A solver that its plan has set up knows its steps.
      if (!description_.adapts && simulation_.size().first > 0)
        known = simulation_.estimate();
    });
    const std::string gap =
      cost.is_exact ? "" : gap_of_steps(description_, prm_, cost);
    cost.gap = gap.empty() ? gap_of_trials(description_) : gap;
    // Tables have rows by steps.
    if (!gap.empty())
      cost.steps = cost.seconds = cost.output = 0.;
    else if (!cost.is_exact)
      correct_steps(known.steps, rough.steps, time_, cost);
    if (description_.on_cost_estimate)
      description_.on_cost_estimate(cost);
    else
      write_check(cost);
    show_line(
      description_.name + " would run" +
      (description_.on_cost_estimate ? "" : " " + command_.parameter_file) +
      " on " + counted_ranks(n_ranks()) + " to time " +
      brief(time_.end_time, 6) + " s, with output in " + folder_.path() + ":");
    for (const std::string &line : cost_lines({{description_.name, cost}}))
      show_line(line);
    complete_plan();
    // A part of a scene, which has a plan of its own, shows warnings alone.
    for (const std::string &line : plan_lines(plan_))
      description_.on_cost_estimate ? log_line(line) : show_line(line);
    warn();
    show_line("The parameters are valid.");
  }

  unsigned int Run::n_ranks() const
  {
    return dealii::Utilities::MPI::n_mpi_processes(collective_.communicator());
  }

  void Run::complete_plan()
  {
    if (!description_.coarsen ||
        std::none_of(plan_.begin(), plan_.end(), [](const Assumption &item) {
          return std::isnan(item.value) && std::isfinite(item.limit);
        }))
      return;
    const auto coarse = coarse_plan(description_, prm_, collective_);
    // Other figures of coarse cells are not those of a scene's run.
    const bool is_part = static_cast<bool>(description_.on_cost_estimate);
    for (Assumption &item : plan_)
      if (const Assumption *known = find_assumption(coarse, item.name);
          known != nullptr && std::isnan(item.value) &&
          (!is_part || item.name == "first_stage"))
      {
        item.value = known->value;
        item.quantity = known->quantity;
      }
    // Others go by the state, whose figures coarse cells do not have.
    for (std::size_t i = 0; i < coarse.size() && !is_part; ++i)
      if (find_assumption(plan_, coarse[i].name) == nullptr)
      {
        Assumption item = coarse[i];
        if (item.name != "first_stage")
          item.value = std::numeric_limits<double>::quiet_NaN();
        plan_.insert(plan_.begin() + std::min(i, plan_.size()), item);
      }
  }

  void Run::warn()
  {
    // A scene knows what of its parts the user wrote.
    if (description_.on_cost_estimate)
      return;
    warn_of_unused(command_, prm_);
    if (description_.oversights)
      for (const std::string &line : description_.oversights(prm_))
        show_line(line);
  }

  void Run::write_check(const CostEstimate &cost)
  {
    collective_.run([&]() {
      std::vector<std::string> outputs = summary_outputs(simulation_.plan());
      std::vector<std::string> tables;
      if (description_.tables)
        tables = description_.tables(prm_);
      for (const std::string &output : file_outputs(folder_.names(), tables))
        outputs.push_back(output);
      if (dealii::Utilities::MPI::this_mpi_process(
            collective_.communicator()) == 0)
        write_check_file({description_.name, cost, outputs});
    });
  }

  void Run::prepare()
  {
    show_line(description_.name + " " + version() + " (" + git_revision() +
              "), " + counted_ranks(n_ranks()) + ", " +
              command_.parameter_file);
    const TimerScope timer("setup");
    simulation_.set_output_folder(folder_.path());
    if (folder_.resumes())
    {
      auto exempt = free_entries;
      exempt.insert(exempt.end(),
                    description_.free_on_resume.begin(),
                    description_.free_on_resume.end());
      const std::string checkpoint =
        folder_.find_checkpoint(exempt, time_.end_time);
      collective_.run([&]() { simulation_.restore(checkpoint); },
                      ExitCode::bad_input);
      state_ = folder_.resume();
      show_line("resumed from " + checkpoint + ", step " +
                std::to_string(state_.step) + ", time " +
                brief(state_.time, 6) + " s");
    }
    else
    {
      collective_.run([&]() { simulation_.setup(); }, ExitCode::bad_input);
      folder_.start();
    }
    const auto size = simulation_.size();
    show_line(std::to_string(size.first) + " cells, " +
              std::to_string(size.second) + " unknowns; output in " +
              folder_.path());
    collective_.run([&]() { plan_ = simulation_.plan(); });
    folder_.keep_estimates(plan_);
    for (const std::string &line : plan_lines(plan_))
      log_line(line);
    warn();
    folder_.write_text("parameters.prm", parameter_text_);
    collective_.run([&]() {
      Log::instance().open(folder_.path("log.txt"), folder_.resumes());
    });
  }

  void Run::execute()
  {
    if (!folder_.claim(command_))
      return;
    estimate();
    prepare();

    folder_.begin_loop();
    RunLoop loop(time_, simulation_, folder_, collective_);
    bool is_drawn = true;
    try
    {
      const bool is_finished = loop.run(state_) == RunStatus::finished;
      folder_.flush();
      if (is_finished)
        collective_.run([&]() { simulation_.finish(folder_.path()); });
      warn_of_gaps(is_finished);
      warn_of_retries();
      const std::string status = is_finished ? "finished" : "stopped";
      summarise(status, told_stop(loop.stop_signal()));
      if (is_finished)
        is_drawn = draw_pictures();
      folder_.set_status(status);
    }
    catch (const std::exception &)
    {
      const Failure failure =
        to_failure(std::current_exception(), ExitCode::system_failed);
      try
      {
        folder_.flush();
        summarise("failed", failure.message);
        folder_.set_status("failed");
      }
      catch (const std::exception &)
      {
        // Report the first failure.
      }
      throw;
    }
    if (loop.stop_signal() != 0)
      throw Stopped(loop.stop_signal());
    collective_.run([&]() {
      if (!is_drawn)
        SignalGuard::require_no_stop();
    });
  }

  void Run::warn_of_gaps(const bool is_finished)
  {
    collective_.run([&]() {
      for (const std::string &gap : simulation_.gaps())
        log_line("WARNING: " + gap +
                 (is_finished ? "; a later Time/End time may give it"
                              : "; --resume goes on"));
    });
  }

  void Run::warn_of_retries() const
  {
    constexpr double largest_share = 0.05;
    if (state_.retries > largest_share * state_.step)
      log_line(
        "WARNING: steps became unphysical and were halved " +
        std::to_string(state_.retries) + " times in " +
        std::to_string(state_.step) +
        " steps: peaks may be wrong by a tenth and more; a smaller CFL or "
        "Courant number avoids it");
  }

  void Run::summarise(const std::string &status, const std::string &message)
  {
    const MPI_Comm all = collective_.communicator();
    Summary summary;
    summary.application = description_.name;
    summary.status = status;
    summary.message = message;
    summary.state = state_;
    summary.ranks = n_ranks();
    summary.first_values = folder_.first_values();
    summary.last_values = folder_.last_values();
    summary.plan = plan_;
    if (status != "failed")
      collective_.run([&]() { describe(simulation_, summary); });
    else
      std::tie(summary.cells, summary.unknowns) = simulation_.size();
    summary.starts = folder_.starts();
    const std::chrono::duration<double> elapsed =
      std::chrono::steady_clock::now() - begin_;
    log_line(std::string("timers") +
             (folder_.resumes() ? " of this start" : "") +
             ", some within others:\n" +
             Timers::instance().table(all, elapsed.count()));
    show_line(status + " at step " + std::to_string(state_.step) + ", time " +
              brief(state_.time, 6) + " s, after " +
              duration(summary.starts.wall_seconds) +
              (message.empty() ? "" : ": " + message));
    for (const NamedValue &error : summary.errors)
      show_line("  " + error.name + " = " + brief(error.value, 6));
    for (const std::string &line : audit_lines(plan_, summary.audit))
      log_line(line);
    summary.starts = folder_.starts(); // with the warnings of the audit
    if (status == "finished")
      replace_estimates(plan_, summary.audit, summary.starts.warnings);
    folder_.write_text("summary.json", to_text(summary));
    show_line("results in " + folder_.path());
    collective_.run([]() { Log::instance().check(); });
  }

  bool Run::draw_pictures() const
  {
    if (description_.pictures.empty() || !prm_.get_bool({"Output"}, "Pictures"))
      return true;
    const MPI_Comm all = collective_.communicator();
    bool is_drawn = true;
    collective_.run([&]() {
      if (dealii::Utilities::MPI::this_mpi_process(all) == 0)
        is_drawn =
          draw(description_.pictures, folder_.path(), "pictures", "pictures");
    });
    return is_drawn;
  }
} // namespace io
} // namespace contrecoup

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/io/output/pictures.h>
#include <contrecoup/study/report.h>
#include <contrecoup/study/study.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <map>

namespace contrecoup::study
{
namespace
{
  namespace fs = std::filesystem;
  using Json = nlohmann::ordered_json;

  constexpr const char *marker = "study.json";

  /// File names of a study with these runs in its folder.
  io::FileNames file_names(const std::string &folder,
                           const std::vector<Task> &tasks)
  {
    io::FileNames names = {{"parameters.prm",
                            marker,
                            "study.csv",
                            "study.md",
                            "recommended.prm",
                            "summary.json"},
                           {"log.txt"}};
    for (const Task &task : tasks)
    {
      const std::string variant = task.folder.substr(folder.size() + 1) + "/";
      for (const char *name :
           {"outcome.json", "screen.txt", "errors.txt", "run/"})
        names.others.push_back(variant + name);
    }
    return names + io::picture_files({"work_precision.svg",
                                      "work_precision.png",
                                      "stability_map.svg",
                                      "stability_map.png"});
  }

  Settings joined(Settings first, const Settings &second)
  {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }

  void write_text(const std::string &file, const std::string &text)
  {
    io::write_file(file, [&](std::ostream &out) { out << text; });
  }

  std::map<std::string, unsigned int> count_outcomes(const StudyResult &result)
  {
    std::map<std::string, unsigned int> counts;
    for (const ResultRow &row : result.rows)
      ++counts[row.outcome.kind];
    return counts;
  }

  std::string told_counts(const StudyResult &result)
  {
    std::vector<std::string> parts;
    for (const auto &[kind, count] : count_outcomes(result))
      parts.push_back(std::to_string(count) + " " + kind);
    return join(parts, ", ");
  }

  /// Order between the two finest meshes of each series.
  Json last_orders(const StudyResult &result)
  {
    Json orders = Json::object();
    std::map<std::size_t, double> finest;
    for (const ResultRow &row : result.rows)
      if (std::isfinite(row.order) &&
          (finest.count(row.series) == 0 || row.width < finest[row.series]))
      {
        finest[row.series] = row.width;
        orders[result.series[row.series]] = row.order;
      }
    return orders;
  }
} // namespace

Study::Study(const StudyParameters &parameters,
             const std::string &output_folder)
  : parameters_(parameters)
  , folder_(output_folder)
  , application_(parameters.application,
                 parameters.parameter_file,
                 parameters.ranks)
  , begin_(std::chrono::steady_clock::now())
{
  require_known_entries();
  if (const auto &reference = parameters_.error.reference_settings())
  {
    has_reference_ = true;
    Variant variant;
    variant.settings = *reference;
    tasks_.push_back(make_task(variant));
  }
  for (const Variant &variant :
       make_design(parameters_.factors, parameters_.design))
    tasks_.push_back(make_task(variant));
}

void Study::require_known(const Settings &settings,
                          const std::string &where) const
{
  for (const auto &setting : settings)
    try
    {
      application_.entries({setting});
    }
    catch (const InputError &error)
    {
      throw InputError(where + ": " + error.what());
    }
}

void Study::require_known_entries() const
{
  // The application validates each value when it is set, even if it is set
  // again later: one start checks all values.
  Settings all = parameters_.settings;
  for (const Factor &factor : parameters_.factors)
    if (factor.is_range)
      for (const double end : {factor.lower, factor.upper})
        all.emplace_back(factor.entries.front(), brief(end, 6));
    else
      for (std::size_t row = 0; row < factor.values.size(); ++row)
        all = joined(all, factor.settings(row));
  if (const auto &reference = parameters_.error.reference_settings())
    all = joined(all, *reference);
  try
  {
    application_.entries(all);
  }
  catch (const InputError &)
  {
    application_.entries({});
    require_known(parameters_.settings, "Study/Settings");
    for (const Factor &factor : parameters_.factors)
      for (std::size_t row = 0; row < factor.values.size(); ++row)
        require_known(factor.settings(row), "Vary " + factor.name);
    if (const auto &reference = parameters_.error.reference_settings())
      require_known(*reference, "Error/Reference");
    throw;
  }
}

Task Study::make_task(const Variant &variant) const
{
  Task task;
  task.variant = variant;
  task.variant.settings = joined(parameters_.settings, variant.settings);
  return task;
}

void Study::identify_tasks()
{
  base_entries_ = application_.entries({});
  const std::string version = application_.version();
  for (Task &task : tasks_)
  {
    std::map<std::string, std::string> entries = base_entries_;
    for (const auto &[entry, value] : task.variant.settings)
      entries[entry] = value;
    task.identity =
      identity(application_.name(), version, application_.ranks(), entries);
    task.folder = path("variants/" + fingerprint(task.identity));
  }
  if (has_reference_)
    parameters_.error.set_reference_folder(tasks_.front().run_folder());
}

std::string Study::path(const std::string &name) const
{
  return folder_ + "/" + name;
}

std::string Study::task_label(const Task &task) const
{
  const bool is_reference = has_reference_ && &task == &tasks_.front();
  return is_reference ? "the reference run" : join(task.variant.labels, ", ");
}

std::string Study::plan_of_first() const
{
  const Task &first = tasks_.front();
  try
  {
    return application_.plan(first.variant.settings);
  }
  catch (const InputError &error)
  {
    throw InputError("the first run (" + task_label(first) +
                     "): " + error.what());
  }
}

void Study::check() const
{
  const std::string plan = plan_of_first();
  show_line("study would run " + std::to_string(tasks_.size()) + " times " +
            application_.name() + " on " + parameters_.parameter_file + ":");
  for (const Factor &factor : parameters_.factors)
    show_line("  " + factor.name + ": " +
              (factor.is_range
                 ? brief(factor.lower) + " to " + brief(factor.upper)
                 : join(factor.labels, "; ")));
  show_line("  output " + folder_);
  show_line("The first run:");
  show_line(plan);
}

bool Study::has_outcomes() const
{
  std::error_code ignored;
  for (const auto &variant : fs::directory_iterator(path("variants"), ignored))
    if (fs::exists(variant.path() / "outcome.json", ignored))
      return true;
  return false;
}

void Study::prepare(const std::string &parameter_text,
                    const bool resume,
                    io::FolderClaim &claim)
{
  if (resume && !fs::exists(path(marker)))
    throw InputError("--resume: \"" + folder_ + "\" holds no study");
  if (resume)
    claim.resume();
  else
    claim.begin();
  fs::create_directories(path("variants"));
  for (Task &task : tasks_)
    if (resume)
      task.outcome = read_outcome(
        task.outcome_file(), task.identity, parameters_.time_limit);
  write_text(path("parameters.prm"), parameter_text);
  write_text(path(marker), to_json(parameters_, {}));
  Log::instance().open(path("log.txt"), resume);
  for (const Task &task : tasks_)
    n_done_ += task.outcome ? 1 : 0;
  n_done_before_ = n_done_;
  show_line(
    "study " + version() + " (" + git_revision() +
    "): " + std::to_string(tasks_.size()) + " runs of " + application_.name() +
    " on " + parameters_.parameter_file +
    (resume ? ", " + std::to_string(n_done_) + " of them done before" : ""));
}

void Study::report(const Task &task)
{
  ++n_done_;
  const Outcome &outcome = *task.outcome;
  const double passed =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_)
      .count();
  const auto done_now = static_cast<double>(n_done_ - n_done_before_);
  const auto left = static_cast<double>(tasks_.size() - n_done_);
  const std::string progress = std::to_string(n_done_) + " of " +
                               std::to_string(tasks_.size()) + " runs, ";
  const std::string time_left = duration(passed * left / done_now) + " left";
  log_line(progress + outcome.kind + " after " +
           duration(outcome.wall_seconds) + ", about " + time_left + ": " +
           task_label(task) +
           (outcome.reason.empty() ? "" : ": " + one_line(outcome.reason)));
  const std::size_t n = tasks_.size();
  Log &log = Log::instance();
  log.status(progress + time_left);
  const bool is_quarter = 4 * n_done_ / n > 4 * (n_done_ - 1) / n;
  if (is_quarter && n_done_ < n && !log.on_terminal() && !log.is_verbose())
    log.progress(progress + time_left);
  const bool is_reference = has_reference_ && &task == &tasks_.front();
  if (is_reference && !outcome.is_usable())
    throw NumericsError("the reference run is " + outcome.kind + ": " +
                        outcome.reason);
  // Early results also reveal a misspelt quantity.
  if (n_done_ < 3 || n_done_ % 10 == 0)
    write_results("running", passed);
}

void Study::write_results(const std::string &status, const double seconds)
{
  std::map<std::string, Outcome> known;
  for (const Task &task : tasks_)
    if (task.outcome)
      known[task.identity] = *task.outcome;
  if (has_reference_ && known.count(tasks_.front().identity) == 0)
    return;
  std::vector<Task> variants(tasks_.begin() + (has_reference_ ? 1 : 0),
                             tasks_.end());
  for (Task &task : variants)
    if (known.count(task.identity) > 0)
      task.outcome = known[task.identity];
  const StudyResult result = evaluate(parameters_, variants);
  write_text(path("study.csv"), to_csv(parameters_, result));
  write_text(path("study.md"), to_markdown(parameters_, result));
  write_text(path(marker), to_json(parameters_, result));
  const Json orders = last_orders(result);
  Json summary = {{"application", "study"},
                  {"version", version()},
                  {"git_revision", git_revision()},
                  {"status", status},
                  {"application_under_study", application_.name()},
                  {"variants", variants.size()},
                  {"outcomes", count_outcomes(result)},
                  {"wall_seconds", seconds},
                  {"errors", Json::object()},
                  {"orders", orders}};
  if (orders.size() == 1)
    summary["errors"][parameters_.error.short_name() + "_order"] =
      orders.begin().value();
  if (result.recommended)
    summary["recommended"] = result.rows[*result.recommended].variant.labels;
  write_text(path("summary.json"), summary.dump(2) + "\n");
  if (status == "finished")
    write_recommendation(result);
}

void Study::write_recommendation(const StudyResult &result)
{
  io::remove_quietly(path("recommended.prm"));
  if (result.recommended)
    write_text(path("recommended.prm"),
               recommended_file(parameters_,
                                result,
                                result.rows[*result.recommended].folder +
                                  "/parameters.prm",
                                base_entries_));
  draw();
  show_line("finished: " + told_counts(result));
  for (const std::string &line : result.remarks)
    show_line(line);
  for (const std::string &line : recommendation(parameters_, result))
    show_line(line);
  show_line("results in " + folder_);
  const auto counts = count_outcomes(result);
  if (counts.size() == 1 && counts.count("refused") == 1)
    throw InputError("all variants were refused; the first (" +
                     join(result.rows.front().variant.labels, ", ") +
                     "): " + result.rows.front().outcome.reason);
}

void Study::draw() const
{
  try
  {
    const io::TemporaryFolder temporary;
    const ProcessText text =
      run_process({io::plot_program(), "study", folder_}, temporary.path());
    if (text.end.exit_code != 0 || text.end.signal != 0)
      throw SystemError(text.errors);
  }
  catch (const SystemError &error)
  {
    log_line("WARNING: there are no pictures: " + std::string(error.what()));
  }
}

void Study::execute(const io::CommandLine &command,
                    const std::string &parameter_text,
                    const std::map<std::string, std::string> &entries)
{
  identify_tasks();
  io::FolderClaim claim(
    folder_, "study", file_names(folder_, tasks_), io::make_run_input(entries));
  if (!claim.may_proceed(
        command, [&]() { return has_outcomes(); }, "more values"))
    return;
  prepare(parameter_text, command.resume, claim);
  begin_ = std::chrono::steady_clock::now();
  VariantRunner runner(application_, parameters_.cores, parameters_.time_limit);
  const bool complete =
    runner.run(tasks_, [&](const Task &task) { report(task); });
  const double seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_)
      .count();
  const std::string status = complete ? "finished" : "stopped";
  write_results(status, seconds);
  claim.set_status(status);
  if (!complete)
    show_line("stopped after " + std::to_string(n_done_) + " of " +
              std::to_string(tasks_.size()) +
              " runs; --resume goes on with the others");
  Log::instance().check();
  if (!complete)
    SignalGuard::require_no_stop();
}
} // namespace contrecoup::study

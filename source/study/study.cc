// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/io/output/pictures.h>
#include <contrecoup/study/report.h>
#include <contrecoup/study/study.h>
#include <contrecoup/study/variant_forecast.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <map>

namespace contrecoup::study
{
namespace
{
  namespace fs = std::filesystem;
  constexpr const char *marker = "study.json";
  /// Lines of progress, and of failures or remarks, on the screen.
  constexpr std::size_t most_lines = 10, most_failures = 3;

  /// File names of a study with these runs in its folder.
  io::FileNames file_names(const std::string &folder,
                           const std::vector<Task> &tasks)
  {
    io::FileNames names = {{"parameters.prm",
                            marker,
                            "study.csv",
                            "study.md",
                            "outputs.csv",
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
                                      "stability_map.png",
                                      "curves.svg",
                                      "curves.png",
                                      "chart.svg",
                                      "chart.png"});
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
      parts.push_back(
        std::to_string(count) + " " + kind +
        (kind == "retried" ? " (" + std::string(retried_in_words) + ")" : ""));
    return join(parts, ", ");
  }

  /// Failure of the program for variants that did not finish; none in a
  /// stability map, whose results they are.
  std::optional<Failure> failure_of(const StudyParameters &parameters,
                                    const StudyResult &result)
  {
    const ResultRow *first = nullptr;
    for (const ResultRow &row : result.rows)
      if (!first && !row.outcome.is_usable())
        first = &row;
    const auto counts = count_outcomes(result);
    const bool all_refused = counts.size() == 1 && counts.count("refused") == 1;
    if (!first || (parameters.mode == "stability map" && !all_refused))
      return {};
    const std::string of_first = "; the first (" +
                                 join(first->variant.labels, ", ") +
                                 "): " + one_line(first->outcome.reason);
    if (all_refused)
      return Failure{ExitCode::bad_input,
                     "all variants were refused" + of_first};
    return Failure{ExitCode::numerics_failed,
                   std::to_string(result.n_unfinished()) + " of " +
                     std::to_string(result.rows.size()) +
                     " variants did not finish" + of_first};
  }

  /// Warns of what the numbers of the table do not show.
  void warn_of(const StudyResult &result)
  {
    for (const std::string &title : result.empty_columns())
      log_line("WARNING: Study/Columns: no run has a value of \"" + title +
               "\"");
    const auto warn = [&](const bool reference,
                          const std::size_t n,
                          const std::string &of_one,
                          const std::string &of_more,
                          const std::string &what) {
      std::vector<std::string> runs;
      if (reference)
        runs.emplace_back(reference_name);
      if (n > 0)
        runs.push_back(std::to_string(n) + " of " +
                       std::to_string(result.rows.size()) + " runs");
      if (!runs.empty())
        log_line("WARNING: " + join(runs, " and ") +
                 (reference + n == 1 ? of_one : of_more) + what);
    };
    warn(false,
         result.n_cut_off(),
         " ends",
         " end",
         " before a positive phase, a contact, a strain or a pressure does: "
         "what study.md marks with ≥ or ≤ is a lower limit of its magnitude; a "
         "later end time gives all of it");
    warn(!result.reference_warnings.empty(),
         result.n_warned(),
         " has",
         " have",
         " warnings, which study.md lists");
  }

  double seconds_since(const std::chrono::steady_clock::time_point begin)
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                         begin)
      .count();
  }

  /// Order between the two finest meshes of each series.
  io::Json last_orders(const StudyResult &result)
  {
    io::Json orders = io::Json::object();
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
{
  require_known_entries();
  parameters_.error.require_reference();
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

void Study::require_known_entries()
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
    const EntryList list = application_.entries(all);
    for (Factor &factor : parameters_.factors)
      if (const auto unit = list.units.find(factor.entries.front());
          factor.unit.empty() && unit != list.units.end())
        factor.unit = unit->second;
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
  base_entries_ = application_.entries({}).values;
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

bool Study::is_reference(const Task &task) const
{
  return has_reference_ && &task == &tasks_.front();
}

std::string Study::task_label(const Task &task) const
{
  return is_reference(task) ? reference_name : join(task.variant.labels, ", ");
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
  // The reference run tells nothing of how long the variants take.
  if (is_reference(task))
  {
    n_done_before_ = n_done_;
    variants_begin_ = std::chrono::steady_clock::now();
  }
  const double passed = seconds_since(variants_begin_);
  const auto done_now = static_cast<double>(n_done_ - n_done_before_);
  const auto left = static_cast<double>(tasks_.size() - n_done_);
  const std::string line =
    std::to_string(n_done_) + " of " + std::to_string(tasks_.size()) + "  " +
    outcome.kind + "  " + duration(outcome.wall_seconds) + "  " +
    task_label(task) +
    (outcome.reason.empty() ? "" : ": " + one_line(outcome.reason)) +
    (is_reference(task)
       ? ""
       : "  (about " + duration(passed * left / done_now) + " left)");
  // The screen gets some ten lines, and the first failures.
  const std::size_t part = most_lines * n_done_ / tasks_.size();
  const bool is_failure = !outcome.is_usable() && ++n_failed_ <= most_failures;
  if (is_failure || tasks_.size() <= most_lines || part > n_parts_shown_)
    show_line(line);
  else
    log_line(line);
  n_parts_shown_ = part;
  Log::instance().status(line);
  if (is_reference(task) && !outcome.is_usable())
    throw NumericsError(std::string(reference_name) + " is " + outcome.kind +
                        ": " + outcome.reason);
  // The first results also reveal a misspelt quantity.
  if (outcome.is_usable() && ++n_usable_ < 3)
    write_results("running", passed);
  else if (n_done_ % 10 == 0)
    write_results("running", passed);
}

void Study::write_outputs() const
{
  for (auto task = tasks_.rbegin(); task != tasks_.rend(); ++task)
    if (task->outcome && task->outcome->is_usable())
    {
      write_text(path("outputs.csv"), outputs_csv(task->run_folder()));
      return;
    }
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
  write_outputs();
  const StudyResult result = evaluate(parameters_, variants);
  if (status == "finished")
    warn_of(result);
  write_text(path("study.csv"), to_csv(parameters_, result));
  write_text(path("study.md"), to_markdown(parameters_, result));
  write_text(path(marker), to_json(parameters_, result));
  write_summary(status, seconds, variants.size(), result);
  if (status == "finished")
    conclude(result);
}

void Study::write_summary(const std::string &status,
                          const double seconds,
                          const std::size_t n_variants,
                          const StudyResult &result) const
{
  const io::Json orders = last_orders(result);
  io::Json summary = {
    {"application", "study"},
    {"format", io::formats::summary.number},
    {"version", version()},
    {"git_revision", git_revision()},
    {"status", status},
    {"application_under_study", application_.name()},
    {"variants", n_variants},
    {"finished_variants", result.rows.size() - result.n_unfinished()},
    {"failed_variants", result.n_unfinished()},
    {"outcomes", count_outcomes(result)},
    {"wall_seconds", seconds},
    {"errors", io::Json::object()},
    {"orders", orders},
    {"warnings", Log::instance().warnings()}};
  if (orders.size() == 1)
    summary["errors"][parameters_.error.short_name() + "_order"] =
      orders.begin().value();
  if (result.recommended)
    summary["recommended"] = result.rows[*result.recommended].variant.labels;
  write_text(path("summary.json"), summary.dump(2) + "\n");
}

void Study::conclude(const StudyResult &result)
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
  for (std::size_t i = 0; i < result.remarks.size(); ++i)
    if (i < most_failures)
      show_line(result.remarks[i]);
    else
      log_line(result.remarks[i]);
  for (const std::string &line : recommendation(parameters_, result))
    show_line(line);
  show_line("results in " + folder_ +
            ": study.md, study.csv, pictures; outputs.csv lists the outputs "
            "of a run");
  failure_ = failure_of(parameters_, result);
}

void Study::draw() const
{
  try
  {
    const io::TemporaryFolder temporary;
    const ProcessText text =
      run_process({io::plot_program(), "study", folder_}, temporary.path());
    if (text.end.exit_code != 0 || text.end.signal != 0)
      throw SystemError(text.end.signal != 0
                          ? "ended by signal " + std::to_string(text.end.signal)
                          : text.errors);
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
  require_possible_outputs(
    forecast_variants(application_, tasks_, 1, parameters_.cores, false));
  prepare(parameter_text, claim.goes_on(command, has_outcomes()), claim);
  const auto begin = std::chrono::steady_clock::now();
  variants_begin_ = begin;
  VariantRunner runner(application_, parameters_.cores, parameters_.time_limit);
  const bool complete =
    runner.run(tasks_, [&](const Task &task) { report(task); });
  const double seconds = seconds_since(begin);
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
  if (failure_)
    throw_failure(*failure_);
}
} // namespace contrecoup::study

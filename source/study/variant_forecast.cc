// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/study/run_outputs.h>
#include <contrecoup/study/variant_forecast.h>

#include <fnmatch.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <list>
#include <regex>
#include <sstream>
#include <thread>

namespace contrecoup::study
{
namespace
{
  const std::string seconds_variable = "CONTRECOUP_CHECK_SECONDS";
  /// Time for the trial runs of all variants, and the least for each [s].
  constexpr double all_seconds = 60., least_seconds = 0.25;

  /// Time for the trial runs of each of @p count variants [s].
  double trial_seconds(const double count, const double slots)
  {
    const char *text = std::getenv(seconds_variable.c_str());
    const double wanted = text ? std::strtod(text, nullptr) : 4.;
    return std::min(wanted,
                    std::max(least_seconds, all_seconds * slots / count));
  }

  /// A running --check.
  struct Running
  {
    VariantForecast *forecast;
    std::unique_ptr<io::TemporaryFolder> folder;
    std::unique_ptr<ChildProcess> process;
  };

  Running start(const ApplicationUnderStudy &application,
                const Task &task,
                const double seconds,
                VariantForecast &forecast)
  {
    Running running{&forecast, std::make_unique<io::TemporaryFolder>(), {}};
    const std::string path = running.folder->path();
    std::vector<std::string> command =
      application.command(task.variant.settings, path + "/run");
    command.emplace_back("--check");
    running.process = std::make_unique<ChildProcess>(
      command,
      path + "/output.txt",
      path + "/errors.txt",
      std::vector<std::string>{"CONTRECOUP_CHECK_FILE=" + path + "/check.json",
                               seconds_variable + "=" + exact(seconds)});
    return running;
  }

  void finish(const ApplicationUnderStudy &application,
              const ProcessEnd &end,
              const Running &running)
  {
    const std::string path = running.folder->path();
    VariantForecast &forecast = *running.forecast;
    const std::string mark = "WARNING: ";
    // An entry that one variant does not use may be needed by another.
    std::istringstream lines(io::read_file(path + "/output.txt"));
    for (std::string line; std::getline(lines, line);)
      if (line.find(" set but not used: ") == std::string::npos)
      {
        forecast.text += line + "\n";
        if (begins_with(line, mark))
          forecast.warnings.push_back(line.substr(mark.size()));
      }
    if (end.exit_code != 0 || end.signal != 0)
      forecast.refusal = application.refusal(
        {end, "", last_line(io::read_file(path + "/errors.txt"))});
    else if (std::filesystem::exists(path + "/check.json"))
      forecast.report = io::read_check_file(path + "/check.json");
  }

  std::string literal_begin(const std::string &pattern)
  {
    return pattern.substr(0, pattern.find('*'));
  }

  bool has_letter(const std::string &text, const char letter)
  {
    return text.find(letter) != std::string::npos;
  }

  /// End of @p address after as many separators as @p begin has.
  std::string end_after(const std::string &begin, const std::string &address)
  {
    const char separator = has_letter(address, ':') ? ':' : '.';
    std::size_t place = 0;
    for (auto left = std::count(begin.begin(), begin.end(), separator);
         left > 0 && place != std::string::npos;
         --left)
    {
      place = address.find(separator, place);
      place += place == std::string::npos ? 0 : 1;
    }
    return place == std::string::npos ? "" : address.substr(place);
  }

  /// Whether two beginnings of addresses may be meant for one another: folders
  /// and what follows them are equal or nearly so.
  bool are_near(const std::string &asked, const std::string &begin)
  {
    const auto near = [](const std::string &a, const std::string &b) {
      return a == b || !nearest(a, {b}).empty();
    };
    const std::size_t first = asked.rfind('/') + 1;
    const std::size_t second = begin.rfind('/') + 1;
    return near(asked.substr(0, first), begin.substr(0, second)) &&
           near(asked.substr(first), begin.substr(second));
  }

  /// Patterns, of tables their names alone, each once.
  std::vector<std::string>
  brief_patterns(const std::vector<std::string> &outputs)
  {
    std::vector<std::string> result;
    for (const std::string &output : outputs)
    {
      const std::string name = has_letter(output, ':')
                                 ? output.substr(0, output.find(':')) + ":*"
                                 : output;
      if (has_letter(name, '*') &&
          std::find(result.begin(), result.end(), name) == result.end())
        result.push_back(name);
    }
    return result;
  }

  /// Whether an address of summary.json is one of a numbered probe that the
  /// history of probes next to it, which has each number, lacks.
  bool is_of_missing_probe(const std::vector<std::string> &outputs,
                           const std::string &address)
  {
    static const std::regex numbered("(.*)results\\.(probe_[0-9]+_).*"),
      history("(.*)probes\\.csv:.*:(probe_[0-9]+_).*");
    std::smatch wanted, found;
    if (!std::regex_match(address, wanted, numbered))
      return false;
    bool has_others = false;
    for (const std::string &output : outputs)
      if (std::regex_match(output, found, history) && found[1] == wanted[1])
      {
        if (found[2] == wanted[2])
          return false;
        has_others = true;
      }
    return has_others;
  }
} // namespace

std::vector<VariantForecast>
forecast_variants(const ApplicationUnderStudy &application,
                  const std::vector<Task> &tasks,
                  const std::size_t count,
                  const unsigned int cores,
                  const bool with_trials)
{
  std::vector<VariantForecast> forecasts(std::min(count, tasks.size()));
  const std::size_t slots = std::max(1U, cores / application.ranks());
  const double seconds =
    with_trials ? trial_seconds(static_cast<double>(forecasts.size()),
                                static_cast<double>(slots))
                : 0.;
  std::list<Running> running;
  std::size_t next = 0, done = 0;
  while (done < forecasts.size())
  {
    SignalGuard::require_no_stop();
    for (; next < forecasts.size() && running.size() < slots; ++next)
      running.push_back(
        start(application, tasks[next], seconds, forecasts[next]));
    for (auto one = running.begin(); one != running.end();)
      if (const auto end = one->process->poll())
      {
        finish(application, *end, *one);
        one = running.erase(one);
        Log::instance().status(std::to_string(++done) + " of " +
                               std::to_string(forecasts.size()) +
                               " runs checked");
      }
      else
        ++one;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return forecasts;
}

CostEstimate sum_of(const std::vector<VariantForecast> &forecasts,
                    const std::size_t slots)
{
  CostEstimate sum;
  std::vector<double> busy_until(std::max<std::size_t>(1, slots), 0.);
  for (const VariantForecast &forecast : forecasts)
  {
    const CostEstimate &cost = forecast.report.cost;
    sum.cells = std::max(sum.cells, cost.cells);
    sum.unknowns = std::max(sum.unknowns, cost.unknowns);
    sum.memory = std::max(sum.memory, cost.memory);
    sum.steps += cost.steps;
    sum.output += cost.output;
    *std::min_element(busy_until.begin(), busy_until.end()) += cost.seconds;
  }
  sum.seconds = *std::max_element(busy_until.begin(), busy_until.end());
  // A figure that is unknown for one is unknown for all.
  for (double CostEstimate::*figure : {&CostEstimate::cells,
                                       &CostEstimate::unknowns,
                                       &CostEstimate::steps,
                                       &CostEstimate::memory,
                                       &CostEstimate::seconds,
                                       &CostEstimate::output})
    for (const VariantForecast &forecast : forecasts)
      if (forecast.refusal.empty() && !(forecast.report.cost.*figure > 0.))
        sum.*figure = 0.;
  return sum;
}

bool can_have(const std::vector<std::string> &outputs,
              const std::string &address)
{
  if (is_of_missing_probe(outputs, address))
    return false;
  return std::any_of(
    outputs.begin(), outputs.end(), [&](const std::string &output) {
      // Without a colon an address is one of summary.json.
      if (has_letter(output, ':') != has_letter(address, ':'))
        return false;
      if (address.find('*') == std::string::npos)
        return fnmatch(output.c_str(),
                       address.c_str(),
                       has_letter(address, ':') ? 0 : FNM_PATHNAME) == 0;
      // Two patterns can agree if what precedes their first "*" does.
      const std::string one = literal_begin(output);
      const std::string other = literal_begin(address);
      return begins_with(one, other) || begins_with(other, one);
    });
}

std::string suggest_output(const std::vector<std::string> &outputs,
                           const std::string &address)
{
  std::vector<std::string> candidates;
  for (const std::string &output : outputs)
  {
    const std::string begin = literal_begin(output);
    const std::string end =
      has_letter(output, '*') ? end_after(begin, address) : "";
    const std::string candidate = begin + end;
    // Any end is possible behind a beginning that is another one.
    const std::string asked = address.substr(0, address.size() - end.size());
    if (candidate != address && can_have({output}, candidate) &&
        are_near(asked, begin))
      candidates.push_back(candidate);
  }
  const std::string best = suggest_address(address, candidates);
  return best.empty() ? "; it has " + join(brief_patterns(outputs), ", ")
                      : best;
}
} // namespace contrecoup::study
